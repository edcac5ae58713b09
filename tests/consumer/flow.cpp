#include <cstdio>

double moment_of_sheet(double radius);

int main() {
  std::printf("%.6f\n", moment_of_sheet(0.5));
}

#include <array>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "io/frames.hpp"
#include "io/hdf5.hpp"
#include "sandbox.hpp"

using namespace vortree::io;

namespace {

struct Element {
  std::string name;
  std::map<std::string, std::string> attributes;
  std::string text;
  std::vector<Element> children;

  [[nodiscard]] std::vector<const Element*> all(const std::string& wanted) const {
    std::vector<const Element*> found;
    for (const Element& child : children) {
      if (child.name == wanted) found.push_back(&child);
      const auto deeper = child.all(wanted);
      found.insert(found.end(), deeper.begin(), deeper.end());
    }
    return found;
  }
};

/// The little XML that such a page needs: nested elements, attributes, text. Fails on anything
/// else.
class Parser {
 public:
  explicit Parser(std::string text) : rest_(std::move(text)) {}

  Element document() {
    REQUIRE(take(R"(<\?xml version="1.0"\?>\s*)"));
    Element root = element();
    CHECK(rest_.empty());
    return root;
  }

 private:
  bool take(const std::string& pattern) {
    if (!std::regex_search(rest_, match_, std::regex(pattern),
                           std::regex_constants::match_continuous)) {
      return false;
    }
    groups_.assign(match_.begin(), match_.end());
    rest_ = match_.suffix().str();
    return true;
  }

  Element element() {
    Element e;
    REQUIRE(take(R"(\s*<([A-Za-z]+))"));
    e.name = groups_[1];
    while (take(R"(\s+([A-Za-z]+)="([^"<&]*)\")")) e.attributes[groups_[1]] = groups_[2];
    if (take(R"(\s*/>\s*)")) return e;
    REQUIRE(take(R"(\s*>\s*)"));
    while (!take("</" + e.name + R"(>\s*)")) {
      if (take(R"([^<>&]+)")) {
        e.text += groups_[0];
      } else {
        e.children.push_back(element());
      }
    }
    return e;
  }

  std::string rest_;
  std::smatch match_;
  std::vector<std::string> groups_;
};

Frame frame_of(std::int64_t step, std::size_t n) {
  const std::vector<double> v(n, 0.5);
  return {.step = step,
          .time = 0.1 * static_cast<double>(step),
          .x = v,
          .y = v,
          .gamma = v,
          .sigma = v,
          .u = v,
          .v = v,
          .state = {}};
}

}  // namespace

TEST_CASE("the XDMF page is XML, and every dataset it names is there with the length it says") {
  const Sandbox box;
  create_frames(box.path(), {});
  for (const auto& [step, n] : std::array<std::pair<int, int>, 3>{{{0, 4}, {5, 7}, {12, 1}}}) {
    append_frame(box.path(), frame_of(step, n));
  }
  const Element page = Parser(text_of(box / "frames.xdmf")).document();
  CHECK(page.name == "Xdmf");
  const h5::Handle file = h5::open_file(box / "frames.h5");
  int named = 0;
  for (const Element* item : page.all("DataItem")) {
    if (item->attributes.contains("Function")) continue;
    REQUIRE(item->attributes.at("Format") == "HDF");
    REQUIRE(item->text.starts_with("frames.h5:/"));
    const auto values = h5::read(file, item->text.substr(item->text.find('/')));
    CHECK(std::to_string(values.size()) == item->attributes.at("Dimensions"));
    ++named;
  }
  CHECK(named == 3 * 8);
}

TEST_CASE("an XDMF page that was lost or hurt is made anew with the next frame") {
  const Sandbox box;
  create_frames(box.path(), {});
  for (const int step : {1, 2, 3}) append_frame(box.path(), frame_of(step, 5));
  const std::string page = text_of(box / "frames.xdmf");
  rewind_frames(box.path(), 2);
  SECTION("gone") {
    std::filesystem::remove(box / "frames.xdmf");
  }
  SECTION("cut") {
    std::filesystem::resize_file(box / "frames.xdmf", 300);
  }
  SECTION("whole") {}
  append_frame(box.path(), frame_of(3, 5));
  CHECK(text_of(box / "frames.xdmf") == page);
}

TEST_CASE("the XDMF page shows every frame at its time, as points with scalars and velocity") {
  const Sandbox box;
  create_frames(box.path(), {});
  CHECK(Parser(text_of(box / "frames.xdmf")).document().all("Time").empty());
  append_frame(box.path(), frame_of(3, 2));
  append_frame(box.path(), frame_of(4, 0));
  append_frame(box.path(), frame_of(10, 9));
  const Element page = Parser(text_of(box / "frames.xdmf")).document();
  const auto grids = page.all("Grid");
  REQUIRE(grids.size() == 3);
  CHECK(grids[0]->attributes.at("CollectionType") == "Temporal");
  CHECK(grids[1]->attributes.at("Name") == "frame_000003");
  CHECK(grids[2]->attributes.at("Name") == "frame_000010");
  CHECK(std::stod(page.all("Time")[0]->attributes.at("Value")) == 0.1 * 3);
  CHECK(page.all("Time")[1]->attributes.at("Value") == "1");
  CHECK(page.all("Topology")[1]->attributes.at("NumberOfElements") == "9");
  CHECK(page.all("Geometry")[0]->attributes.at("GeometryType") == "X_Y");
  std::map<std::string, std::string> shown;
  for (const Element* a : grids[2]->all("Attribute")) {
    shown[a->attributes.at("Name")] = a->attributes.at("AttributeType");
  }
  CHECK(shown == std::map<std::string, std::string>{{"gamma", "Scalar"},
                                                    {"sigma", "Scalar"},
                                                    {"u", "Scalar"},
                                                    {"v", "Scalar"},
                                                    {"velocity", "Vector"}});
}

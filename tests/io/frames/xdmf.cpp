#include <array>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "io/frames/frames.hpp"
#include "io/frames/hdf5.hpp"
#include "io/sandbox.hpp"
#include "io/tables/fields.hpp"

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
          .columns = {{"x", "L", v},
                      {"y", "L", v},
                      {"gamma", "L^2/T", v},
                      {"sigma", "L", v},
                      {"u", "L/T", v},
                      {"v", "L/T", v}}};
}

/// "5 3"; vertices are written "5 1", as one list.
std::string shape_of(hid_t file, const std::string& path) {
  const h5::Handle set = h5::own(H5Dopen2(file, path.c_str(), H5P_DEFAULT), path);
  const h5::Handle space = h5::own(H5Dget_space(set), path);
  std::array<hsize_t, 2> shape{};
  const int dimensions = H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  std::string text = std::to_string(shape[0]);
  if (dimensions == 2) text += " " + std::to_string(shape[1]);
  return path.ends_with("/vertices") ? text + " 1" : text;
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
    REQUIRE(item->attributes.at("Format") == "HDF");
    REQUIRE(item->text.starts_with("frames.h5:/"));
    CHECK(shape_of(file, item->text.substr(item->text.find('/'))) ==
          item->attributes.at("Dimensions"));
    ++named;
  }
  CHECK(named == 3 * 7);
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
  CHECK(page.attributes.at("Version") == "3.0");
  CHECK(page.all("Geometry")[0]->attributes.at("GeometryType") == "XYZ");
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

TEST_CASE("what is drawn of a frame are its positions and velocities, in rows of three") {
  const Sandbox box;
  create_frames(box.path(), {});
  append_frame(
      box.path(),
      {.step = 2,
       .time = 1,
       .columns = {
           {"x", "L", {1, 2}}, {"y", "L", {3, 4}}, {"u", "L/T", {5, 6}}, {"v", "L/T", {7, 8}}}});
  const h5::Handle file = h5::open_file(box / "frames.h5");
  using Doubles = std::vector<double>;
  CHECK(h5::read(file, "frame_000002/view/points") == Doubles{1, 3, 0, 2, 4, 0});
  CHECK(h5::read(file, "frame_000002/view/velocity") == Doubles{5, 7, 0, 6, 8, 0});
  CHECK(h5::read(file, "frame_000002/view/vertices") == Doubles{0, 1});
}

TEST_CASE("the XDMF page of fields names grids of rows and columns that are there") {
  const Sandbox box;
  const Field field{.time = 0.5,
                    .x = {0, 1, 2},
                    .y = {5, 6},
                    .u = std::vector<double>(6, 1.),
                    .v = std::vector<double>(6, 2.),
                    .omega = std::vector<double>(6, 3.)};
  append_field(box.path(), field);
  Field later = field;
  later.time = 1.5;
  later.psi = std::vector<double>(6, 4.);
  later.p = std::vector<double>(6, 5.);
  append_field(box.path(), later);
  const auto check_page = [&](std::size_t grids) {
    const Element page = Parser(text_of(box / "fields.xdmf")).document();
    const h5::Handle file = h5::open_file(box / "fields.h5");
    REQUIRE(page.all("Time").size() == grids);
    CHECK(page.all("Time").back()->attributes.at("Value") == (grids == 1 ? "0.5" : "1.5"));
    CHECK(page.all("Topology")[0]->attributes.at("Dimensions") == "2 3");
    CHECK(page.all("DataItem").size() == (grids == 1 ? 5 : 5 + 7));
    CHECK(page.all("Attribute").back()->attributes.at("Name") == (grids == 1 ? "omega" : "p"));
    for (const Element* item : page.all("DataItem")) {
      REQUIRE(item->text.starts_with("fields.h5:/"));
      CHECK(shape_of(file, item->text.substr(item->text.find('/'))) ==
            item->attributes.at("Dimensions"));
    }
  };
  check_page(2);
  (void)rewind_fields(box.path(), 1);
  check_page(1);
}

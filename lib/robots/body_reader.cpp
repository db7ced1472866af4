// SPDX-License-Identifier: MIT
// Bodies are read even where the file has errors: a bad value has been reported, and a default in
// its place lets the checks that follow find more in one go. The model itself is given out only
// when nothing was reported. Hence defaults such as 1 for a length: they must not cause messages of
// their own.
#include "robots/body_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/degree.h"
#include "base/hull.h"
#include "base/text.h"
#include "robots/solid_pieces.h"

namespace stig::robots {

namespace {

constexpr std::array<std::string_view, 5> kShapes = {"box", "cylinder", "sphere", "hull", "solid"};

// Euler angles z, y', x'': yaw, then pitch, then roll, each about the axes that the ones before
// have left.
Quat turned(const Vec3& degrees_zyx) {
  return rotation(Vec3{0, 0, 1} * (degrees_zyx.x * kDegree)) *
         rotation(Vec3{0, 1, 0} * (degrees_zyx.y * kDegree)) *
         rotation(Vec3{1, 0, 0} * (degrees_zyx.z * kDegree));
}

class BodyReader {
 public:
  BodyReader(const FormView& view, const BodyFile& file, const BodyDefaults& defaults)
      : view_(view), file_(file), defaults_(defaults) {}

  std::vector<BodyModel> read() {
    body_.name = view_.text("name");
    body_.place = file_.document.head(view_.node());
    body_.material = view_.text("material", defaults_.material);
    body_.rgb = parse_color(view_.text("color")).value_or(body_.rgb);
    check_one(kShapes, "a shape: box, cylinder, sphere, hull or solid");
    check_one(std::array<std::string_view, 2>{"base", "center"}, "a place: base or center");
    read_shape();
    read_mass();
    read_place();
    read_inertia();
    if (solid_) return pieces_of(std::move(body_), *solid_);
    return {std::move(body_)};
  }

 private:
  /// A body has one shape and one place; looks at the node itself, since a bad value has been
  /// reported already.
  template <std::size_t N>
  void check_one(const std::array<std::string_view, N>& keys, std::string_view what,
                 bool none_is_good = false) {
    std::vector<std::string_view> found;
    for (const std::string_view key : keys) {
      if (view_.node().find(key) != nullptr) found.push_back(key);
    }
    if (found.size() == 1 || (found.empty() && none_is_good)) return;
    file_.out.add(Code::P604, body_.place,
                  found.empty()
                      ? fmt::format("this body has not {}", what)
                      : fmt::format("this body has both '{}' and '{}'", found[0], found[1]));
  }

  void read_shape() {
    if (view_.has("cylinder")) {
      const FormView form = view_.form("cylinder");
      // Sizes are edge lengths of the box about the shape for every shape.
      const double d = 2 * form.number("radius", 1);
      body_.shape = ShapeType::cylinder;
      body_.size = {d, d, form.number("height", 1)};
    } else if (view_.has("sphere")) {
      body_.shape = ShapeType::sphere;
      body_.size = Vec3{1, 1, 1} * (2 * view_.form("sphere").number("radius", 1));
    } else if (view_.has("hull")) {
      read_hull();
    } else if (view_.has("solid")) {
      read_solid_file(*view_.find("solid"));
    } else {
      body_.size = view_.vector("box", {1, 1, 1});
    }
  }

  void read_hull() {
    body_.shape = ShapeType::hull;
    for (const FormView& corner : view_.forms("hull")) {
      body_.points.push_back(corner.vector("at"));
    }
    const HullMass solid = hull_mass(body_.points);
    // In m³: a cube of a tenth of a millimetre. Four corners in a plane have next to none.
    if (solid.volume <= 1e-12) {
      file_.out.add(Code::P614, file_.document.head(*view_.find("hull")),
                    "the corners of the hull enclose nothing");
      return;
    }
    // The model's frame is that of the middle of mass.
    body_.p_BO = -solid.centre;
    take_size(body_.points);
    for (Vec3& p : body_.points) p -= solid.centre;
  }

  void take_size(const std::vector<Vec3>& points) {
    Vec3 low = points[0], high = low;
    for (const Vec3& p : points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    body_.size = high - low;
  }

  void read_solid_file(const YamlNode& key) {
    const SourceRange place = file_.document.range(key);
    if (is_mesh_name(key.text)) {
      file_.out.add(Code::P617, place,
                    fmt::format("{} is a mesh, not a solid", in_quotes(key.text)));
      return;
    }
    FileError error;
    auto text = file_.load(key.text, kMaxSolidFileBytes, error);
    if (!text) {
      file_.out.add(error.too_large ? Code::R002 : Code::R001, place, error.message);
      return;
    }
    solid_ = read_solid(std::make_shared<SourceFile>(key.text, std::move(*text)), file_.out);
    if (!solid_) return;
    body_.shape = ShapeType::hull;
    body_.p_BO = -solid_->centre;
    std::vector<Vec3> all;
    for (const auto& piece : solid_->pieces) all.insert(all.end(), piece.begin(), piece.end());
    take_size(all);
  }

  void read_mass() {
    check_one(std::array<std::string_view, 2>{"mass", "density"}, "a mass: mass or density",
              defaults_.weightless);
    if (view_.has("density")) {
      const double volume = solid_ ? solid_->volume : volume_of(body_);
      body_.mass = std::max(view_.number("density") * volume, 1e-9);
    } else {
      body_.mass = view_.number("mass", defaults_.weightless ? 0 : 1);
    }
  }

  // X_RB is the pose of the centre of mass. "base" is the middle of the lower face, or a hull's own
  // origin, from which its devices are measured as well; "center" is the centre itself.
  void read_place() {
    body_.X_RB = {view_.vector("base", view_.vector("center")), turned(view_.vector("turn"))};
    if (view_.has("base") && body_.shape != ShapeType::hull) {
      body_.p_BO = {0, 0, -body_.size.z / 2};
    }
    // The shift is in the body's frame: a body that is turned is turned about its base.
    body_.X_RB = body_.X_RB * Pose{-body_.p_BO, {}};
  }

  void read_inertia() {
    if (!view_.has("inertia")) return;
    const Vec3 i = view_.vector("inertia");
    body_.inertia = i;
    // For any distribution of mass each principal moment is at most the sum of the other two.
    // Rounding of figures in the file is forgiven.
    const double most = std::max({i.x, i.y, i.z});
    if (2 * most <= (i.x + i.y + i.z) * (1 + 1e-9)) return;
    file_.out.add(Code::P615, file_.document.range(*view_.find("inertia")),
                  "no body has such moments: one is more than the other two together");
  }

  const FormView& view_;
  const BodyFile& file_;
  const BodyDefaults& defaults_;
  BodyModel body_;
  std::optional<SolidModel> solid_;
};

}  // namespace

std::vector<BodyModel> read_body(const FormView& view, const BodyFile& file,
                                 const BodyDefaults& defaults) {
  return BodyReader(view, file, defaults).read();
}

}  // namespace stig::robots

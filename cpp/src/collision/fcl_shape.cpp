// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "collision/fcl_shape.hpp"

#include <utility>
#include <vector>

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>

#include "graspless/geometry/pose.hpp"
#include "graspless/watch.hpp"

#include "collision/prepared.hpp"
#include "geometry/convex_hull.hpp"

namespace graspless::collision {
namespace {

using Geometry = FclGeometry::Made;

/// Returns the centre of the points' box: the origin of the core's frame.
Eigen::Vector3d box_middle(const Eigen::Matrix3Xd& points) {
  return (points.rowwise().minCoeff() + points.rowwise().maxCoeff()) / 2;
}

Core box_core(const Eigen::Matrix3Xd& centred) {
  return {centred.cwiseAbs().rowwise().maxCoeff(), 0, false};
}

Geometry make_hull(const Eigen::Matrix3Xd& vertices, const Eigen::Matrix3Xi& triangles) {
  auto corners = std::make_shared<std::vector<fcl::Vector3d>>();
  for (Eigen::Index i = 0; i < vertices.cols(); ++i) corners->push_back(vertices.col(i));
  auto faces = std::make_shared<std::vector<int>>();
  for (Eigen::Index i = 0; i < triangles.cols(); ++i) {
    faces->insert(faces->end(), {3, triangles(0, i), triangles(1, i), triangles(2, i)});
  }
  return std::make_shared<fcl::Convexd>(corners, static_cast<int>(triangles.cols()), faces);
}

/// Fits a box to each node of a tree as FCL does, but with polls: a tree of 10^5 triangles takes
/// a quarter of a second. The rounded rectangle, which FCL's collision tests do not look at, is a
/// ball around the box: to fit it takes as long as all the rest.
class BoxFitter : public fcl::detail::BVFitter<fcl::OBBRSSd> {
 public:
  void set(fcl::Vector3d* corners, fcl::Triangle* faces, fcl::BVHModelType type) override {
    BVFitter::set(corners, faces, type);
    corners_ = corners;
    faces_ = faces;
  }
  fcl::OBBRSSd fit(unsigned int* primitives, int count) override {
    poll();
    fcl::OBBRSSd fitted;
    fcl::OBBd& box = fitted.obb;
    fcl::Matrix3d covariance, vectors;
    fcl::Vector3d values;
    fcl::getCovariance<double>(corners_, nullptr, faces_, primitives, count, covariance);
    fcl::eigen_old(covariance, values, vectors);
    fcl::axisFromEigen(vectors, values, box.axis);
    fcl::getExtentAndCenter<double>(corners_, nullptr, faces_, primitives, count, box.axis, box.To,
                                    box.extent);
    fitted.rss.axis = box.axis;
    fitted.rss.To = box.To;
    fitted.rss.l[0] = fitted.rss.l[1] = 0;
    fitted.rss.r = box.extent.norm();
    return fitted;
  }

 private:
  fcl::Vector3d* corners_ = nullptr;
  fcl::Triangle* faces_ = nullptr;
};

Geometry make_surface(const Eigen::Matrix3Xd& vertices, const Eigen::Matrix3Xi& triangles) {
  std::vector<fcl::Vector3d> corners;
  for (Eigen::Index i = 0; i < vertices.cols(); ++i) corners.push_back(vertices.col(i));
  std::vector<fcl::Triangle> faces;
  for (Eigen::Index i = 0; i < triangles.cols(); ++i) {
    faces.emplace_back(triangles(0, i), triangles(1, i), triangles(2, i));
  }
  // FCL's trees of OBB alone are quicker to build, but miss contacts of surfaces.
  auto surface = std::make_shared<fcl::BVHModel<fcl::OBBRSSd>>();
  surface->bv_fitter = std::make_shared<BoxFitter>();
  announce_memory(2.0 * static_cast<double>(faces.size()) * sizeof(fcl::BVNode<fcl::OBBRSSd>));
  const auto require = [](int code) {
    if (code != fcl::BVH_OK) throw std::bad_alloc();  // nothing else can fail here
  };
  require(surface->beginModel(static_cast<int>(faces.size()), static_cast<int>(corners.size())));
  require(surface->addSubModel(corners, faces));
  require(surface->endModel());
  return surface;
}

CollisionShape make_shape(std::function<Geometry()> geometry, HullTree hulls, const Core& core,
                          const Eigen::Vector3d& middle = Eigen::Vector3d::Zero()) {
  return {std::make_shared<const FclGeometry>(std::move(geometry)),
          std::make_shared<const HullTree>(std::move(hulls)),
          core,
          Eigen::Isometry3d(Eigen::Translation3d(middle)),
          {}};
}

CollisionShape make_convex(const geometry::Mesh& hull, bool is_of_mesh) {
  const Eigen::Vector3d middle = box_middle(hull.vertices);
  const Eigen::Matrix3Xd centred = hull.vertices.colwise() - middle;
  HullTree hulls = convex_tree(centred);
  hulls.is_of_mesh = is_of_mesh;
  CollisionShape shape =
      make_shape([centred, faces = hull.triangles] { return make_hull(centred, faces); },
                 std::move(hulls), box_core(centred), middle);
  shape.point = centred.col(0);
  return shape;
}

/// Prepares a surface; `hull`: corners of its convex hull.
CollisionShape make_surface(const geometry::Mesh& mesh, const Eigen::Matrix3Xd& hull) {
  const Eigen::Vector3d middle = box_middle(mesh.vertices);
  const auto centred = std::make_shared<const geometry::Mesh>(
      geometry::Mesh{mesh.vertices.colwise() - middle, mesh.triangles});
  HullTree hulls = surface_tree(centred, hull.colwise() - middle);
  hulls.is_of_mesh = true;
  CollisionShape shape =
      make_shape([centred] { return make_surface(centred->vertices, centred->triangles); },
                 std::move(hulls), box_core(centred->vertices), middle);
  shape.enclosure = std::make_shared<const Enclosure>(*centred);
  return shape;
}

CollisionShape make(const geometry::Box& box) {
  const Core core{box.size / 2, 0, false};
  return make_shape([box] { return std::make_shared<fcl::Boxd>(box.size); }, box_tree(core), core);
}

CollisionShape make(const geometry::Sphere& sphere) {
  const Core core{Eigen::Vector3d::Zero(), sphere.radius, true};
  return make_shape([sphere] { return std::make_shared<fcl::Sphered>(sphere.radius); },
                    box_tree(core), core);
}

CollisionShape make(const geometry::Capsule& capsule) {
  const Core core{{0, 0, capsule.length / 2}, capsule.radius, true};
  return make_shape(
      [capsule] { return std::make_shared<fcl::Capsuled>(capsule.radius, capsule.length); },
      box_tree(core), core);
}

CollisionShape make(const geometry::Convex& convex) {
  return make_convex(geometry::convex_hull(convex.vertices), false);
}

CollisionShape make_mesh(const geometry::Mesh& mesh) {
  if (!geometry::spans_volume(mesh.vertices)) return make_surface(mesh, mesh.vertices);
  const geometry::Mesh hull = geometry::convex_hull(mesh.vertices);
  if (geometry::is_convex(mesh, hull)) return make_convex(hull, true);
  return make_surface(mesh, hull.vertices);
}

CollisionShape make(const geometry::Mesh& mesh) { return prepared(mesh, make_mesh); }

}  // namespace

const fcl::CollisionGeometryd* FclGeometry::get() const {
  once_([this] {
    made_ = make_();
    make_ = nullptr;  // frees what it was made from
  });
  return made_.get();
}

CollisionShape make_collision_shape(const geometry::PlacedShape& placed, const std::string& what) {
  geometry::validate(placed.shape, what);
  geometry::require_pose(placed.X_BG, what + ".X_BG");
  CollisionShape shape = std::visit([](const auto& kind) { return make(kind); }, placed.shape);
  shape.X_BC = placed.X_BG * shape.X_BC;
  return shape;
}

struct FclTest::Scratch {
  fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
};

FclTest::FclTest() : scratch_(std::make_unique<Scratch>()) {
  // libccd was measured on flush and grazing poses: it reports no contact before shapes touch, and
  // misses contacts by less than 5e-7 m. FCL's own solver errs by 1e-6 m to one side and 6e-6 m to
  // the other, and takes twice the time. Without contact points, libccd never enters the code that
  // aborts on flush shapes.
  scratch_->request.gjk_solver_type = fcl::GST_LIBCCD;
  scratch_->request.num_max_contacts = 1;
  scratch_->request.enable_contact = false;
}

FclTest::FclTest(const FclTest&) : FclTest() {}
FclTest::~FclTest() = default;

Touch FclTest::operator()(const CollisionShape& a, const Eigen::Isometry3d& X_WA,
                          const CollisionShape& b, const Eigen::Isometry3d& X_WB) {
  scratch_->result.clear();
  try {
    const auto contacts = fcl::collide(a.geometry->get(), X_WA, b.geometry->get(), X_WB,
                                       scratch_->request, scratch_->result);
    return contacts > 0 ? Touch::yes : Touch::no;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    return Touch::failed;
  }
}

}  // namespace graspless::collision

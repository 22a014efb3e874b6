#include <scree/mesh/mass_properties.hpp>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

#include "principal_axes.hpp"

namespace scree {

namespace {

/// Sums over the tetrahedra that a surface's triangles make with one point. The point is in the middle of the
/// body, so that a body far from the origin loses no digits.
class VolumeIntegrals {
  public:
    explicit VolumeIntegrals(const std::vector<Vec3>& vertices) {
        Eigen::AlignedBox3d box;
        for (const Vec3& v : vertices) {
            box.extend(v);
        }
        if (!vertices.empty()) {
            apex_ = box.center();
        }
    }

    void add(const Vec3& first, const Vec3& second, const Vec3& third) {
        const Vec3 a = first - apex_;
        const Vec3 b = second - apex_;
        const Vec3 c = third - apex_;
        const Vec3 sum = a + b + c;
        const double volume = a.dot(b.cross(c));
        volume_ += volume;
        moment_ += volume * sum;
        second_ +=
            volume * (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
    }

    [[nodiscard]] MassProperties result() const {
        MassProperties mass;
        mass.volume = volume_ / 6;
        if (!(mass.volume > 0) || !std::isfinite(mass.volume)) {
            throw std::invalid_argument("a surface that is closed and outward has a positive volume");
        }
        const Vec3 offset = moment_ / (4 * volume_);
        mass.centroid = apex_ + offset;
        const Mat3 spread = second_ / 120 - mass.volume * offset * offset.transpose();
        mass.inertia = spread.trace() * Mat3::Identity() - spread;
        std::tie(mass.principal_inertia, mass.principal_axes) = principal_axes(mass.inertia);
        return mass;
    }

  private:
    Vec3 apex_ = Vec3::Zero();
    double volume_ = 0;           // ∫ dV · 6
    Vec3 moment_ = Vec3::Zero();  // ∫ x dV · 24
    Mat3 second_ = Mat3::Zero();  // ∫ x xᵀ dV · 120
};

}  // namespace

MassProperties mass_properties(const ConvexPolyhedron& solid) {
    VolumeIntegrals integrals(solid.vertices);
    const auto vertex = [&](int h) -> const Vec3& { return solid.vertices[solid.half_edges[h].vertex]; };
    for (int f = 0; f < solid.face_count(); ++f) {
        const int first = solid.face_begin[f];
        for (int h = first + 1; h + 1 < solid.face_begin[f + 1]; ++h) {
            integrals.add(vertex(first), vertex(h), vertex(h + 1));
        }
    }
    return integrals.result();
}

MassProperties mass_properties(const TriangleMesh& surface) {
    VolumeIntegrals integrals(surface.vertices);
    for (const auto& [a, b, c] : surface.triangles) {
        integrals.add(surface.vertices[a], surface.vertices[b], surface.vertices[c]);
    }
    return integrals.result();
}

double sphere_radius(double volume) {
    return std::cbrt(3 * volume / (4 * std::numbers::pi));
}

}  // namespace scree

#include <scree/overlap/contact_geometry.hpp>

namespace scree {

namespace {

constexpr double least_patch = 1e-3;  // of half the overlap's surface, below which S gives no direction

}  // namespace

ContactGeometry exchanged(const ContactGeometry& g, const Vec3& shift) {
    ContactGeometry other = g;
    other.centroid = g.centroid - shift;
    other.area_vector = -g.area_vector;
    other.normal = -g.normal;
    // The overlap's whole surface has ∫ r nᵀ = V 1 and ∫ r (r×n)ᵀ = 0 about its centroid.
    other.first_moment = g.volume * Mat3::Identity() - g.first_moment;
    other.second_moment = -g.second_moment;
    // B moved against A is A moved back against B, and then both moved together.
    other.boundary.topRightCorner<3, 3>() += cross_matrix(g.area_vector);
    other.boundary.bottomLeftCorner<3, 3>() += cross_matrix(g.area_vector);
    other.boundary.bottomRightCorner<3, 3>() += cross_matrix(g.area_moment());
    other.normal_rate.rightCols<3>() += cross_matrix(g.normal);
    return other;
}

void rotate(ContactGeometry& g, const Mat3& turn) {
    const auto both = [&](const auto& m) -> Mat3 { return turn * m * turn.transpose(); };
    g.centroid = turn * g.centroid;
    g.area_vector = turn * g.area_vector;
    g.normal = turn * g.normal;
    g.first_moment = both(g.first_moment);
    g.second_moment = both(g.second_moment);
    g.tilting = both(g.tilting);
    for (int row = 0; row < 6; row += 3) {
        for (int column = 0; column < 6; column += 3) {
            g.boundary.block<3, 3>(row, column) = both(g.boundary.block<3, 3>(row, column)).eval();
        }
    }
    for (int column = 0; column < 6; column += 3) {
        g.normal_rate.middleCols<3>(column) = both(g.normal_rate.middleCols<3>(column)).eval();
    }
}

void set_normal(ContactGeometry& g, double surface, const Vec3& apart, const Vec3& arm,
                bool was_centre_line) {
    g.area = g.area_vector.norm();
    const double least = (was_centre_line ? 2 : 1) * least_patch * 0.5 * surface;
    g.centre_line = !(g.area >= least) || g.area == 0;
    if (!g.centre_line) {
        g.normal = -g.area_vector / g.area;
        g.normal_rate =
            -(Mat3::Identity() - g.normal * g.normal.transpose()) * g.boundary.topRows<3>() / g.area;
        return;
    }
    const double distance = apart.norm();
    g.normal = distance > 0 ? Vec3(apart / distance) : Vec3::UnitZ();
    g.normal_rate.setZero();
    if (distance * distance * distance <= 1e-6 * g.volume) {
        return;
    }
    const Mat3 across = (Mat3::Identity() - g.normal * g.normal.transpose()) / distance;
    g.normal_rate.leftCols<3>() = across;
    g.normal_rate.rightCols<3>() = -across * cross_matrix(arm);
}

}  // namespace scree

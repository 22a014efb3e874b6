#pragma once

#include <vector>

#include <scree/mesh/vectors.hpp>

namespace scree {

/// A frame in which a cloud of points has its middle at the origin and a largest extent of 1 to 2. The scale
/// is a power of two, so that going there and back changes no digit but by the shift of the origin.
struct UnitFrame {
    Vec3 centre = Vec3::Zero();  ///< [m]
    double scale = 1;            ///< [m] per unit
    double size = 0;             ///< [m], the largest extent along an axis

    [[nodiscard]] std::vector<Vec3> to_unit(const std::vector<Vec3>& points) const;
};

/// The frame of points that span a solid. Throws std::invalid_argument, naming the reason, for those that
/// cannot: too few, not finite, out of range, all equal, on one line, or in one plane to 10⁻⁵ of their size.
UnitFrame unit_frame(const std::vector<Vec3>& points);

/// The numbers of points of which none is nearer than `distance` to another: of those that are, one stays.
std::vector<int> thinned(const std::vector<Vec3>& points, double distance);

}  // namespace scree

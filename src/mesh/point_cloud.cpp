#include "point_cloud.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace scree {

namespace {

constexpr double smallest_size = 1e-9;       // [m]
constexpr double largest_coordinate = 1e9;   // [m]
constexpr double smallest_thickness = 1e-5;  // of the size; ten times what merging faces takes for flat

template <class... Parts>
[[noreturn]] void refuse(const Parts&... parts) {
    std::ostringstream message;
    (message << ... << parts);
    throw std::invalid_argument(message.str());
}

void check_range(const std::vector<Vec3>& points) {
    if (points.size() < 4) {
        refuse("a solid needs at least four points, found ", points.size());
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!points[i].allFinite()) {
            refuse("point ", i, " is not finite");
        }
        if (points[i].cwiseAbs().maxCoeff() > largest_coordinate) {
            refuse("point ", i, " is at ", points[i].cwiseAbs().maxCoeff(), " m, expected at most ",
                   largest_coordinate, " m");
        }
    }
}

/// The point with the largest measure.
template <class Measure>
Vec3 farthest(const std::vector<Vec3>& points, const Measure& measure) {
    return *std::max_element(points.begin(), points.end(),
                             [&](const Vec3& a, const Vec3& b) { return measure(a) < measure(b); });
}

/// Finds a large tetrahedron greedily: a point, the farthest from it, from their line, and from their plane.
void check_thickness(const std::vector<Vec3>& points) {
    const Vec3 start = points.front();
    const Vec3 end = farthest(points, [&](const Vec3& p) { return (p - start).squaredNorm(); });
    const double length = (end - start).norm();
    const Vec3 axis = (end - start) / length;
    const auto from_line = [&](const Vec3& p) { return (p - start).cross(axis).norm(); };
    const Vec3 side = farthest(points, from_line);
    if (from_line(side) <= smallest_thickness * length) {
        refuse("the ", points.size(), " points lie on one line");
    }
    const Vec3 normal = axis.cross(side - start).normalized();
    const auto from_plane = [&](const Vec3& p) { return std::abs((p - start).dot(normal)); };
    if (from_plane(farthest(points, from_plane)) <= smallest_thickness * length) {
        refuse("the ", points.size(), " points lie in one plane");
    }
}

}  // namespace

std::vector<Vec3> UnitFrame::to_unit(const std::vector<Vec3>& points) const {
    std::vector<Vec3> unit;
    unit.reserve(points.size());
    for (const Vec3& p : points) {
        unit.emplace_back((p - centre) / scale);
    }
    return unit;
}

UnitFrame unit_frame(const std::vector<Vec3>& points) {
    check_range(points);
    Eigen::AlignedBox3d box;
    for (const Vec3& p : points) {
        box.extend(p);
    }
    UnitFrame frame;
    frame.size = box.sizes().maxCoeff();
    if (frame.size == 0) {
        refuse("all ", points.size(), " points are the same");
    }
    if (frame.size < smallest_size) {
        refuse("the points span ", frame.size, " m, expected at least ", smallest_size, " m");
    }
    frame.centre = box.center();
    frame.scale = std::exp2(std::floor(std::log2(frame.size)));
    check_thickness(frame.to_unit(points));
    return frame;
}

// A sweep along a direction that no mesh is aligned with: only points within the distance along it are
// compared.
std::vector<int> thinned(const std::vector<Vec3>& points, double distance) {
    const Vec3 along = Vec3(0.6180339887, 0.4656988346, 0.6333).normalized();
    std::vector<std::pair<double, int>> order;
    for (std::size_t i = 0; i < points.size(); ++i) {
        order.emplace_back(along.dot(points[i]), static_cast<int>(i));
    }
    std::sort(order.begin(), order.end());
    std::vector<std::pair<double, int>> kept;
    for (const auto& [place, i] : order) {
        bool near = false;
        for (auto other = kept.rbegin(); !near && other != kept.rend() && other->first >= place - distance;
             ++other) {
            near = (points[other->second] - points[i]).norm() < distance;
        }
        if (!near) {
            kept.emplace_back(place, i);
        }
    }
    std::vector<int> numbers;
    for (const auto& [place, i] : kept) {
        numbers.push_back(i);
    }
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

}  // namespace scree

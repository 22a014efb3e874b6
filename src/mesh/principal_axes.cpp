#include "principal_axes.hpp"

#include <array>
#include <cmath>

#include <Eigen/Eigenvalues>

namespace scree {

namespace {

/// Moments that differ by less than this, relative to their sum, count as equal.
constexpr double equal_moments = 1e-12;

bool is_diagonal(const Mat3& m) {
    const Mat3 rest = m - Mat3(m.diagonal().asDiagonal());
    return rest.cwiseAbs().maxCoeff() <= equal_moments * m.trace();
}

/// Turns the axes i and j in their plane to where they are nearest to the frame's own.
void align_pair(Mat3& axes, int i, int j) {
    const double angle = std::atan2(axes(i, j) - axes(j, i), axes(i, i) + axes(j, j));
    const Vec3 u = axes.col(i);
    const Vec3 v = axes.col(j);
    axes.col(i) = std::cos(angle) * u + std::sin(angle) * v;
    axes.col(j) = -std::sin(angle) * u + std::cos(angle) * v;
}

void align_equal_moments(Mat3& axes, const Vec3& moments) {
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        if (std::abs(moments(i) - moments(j)) <= equal_moments * moments.sum()) {
            align_pair(axes, i, j);
        }
    }
}

}  // namespace

std::pair<Vec3, Quat> principal_axes(const Mat3& inertia) {
    if (is_diagonal(inertia)) {
        return {inertia.diagonal(), Quat::Identity()};
    }
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(inertia);
    static constexpr std::array<std::array<int, 3>, 6> orders{
        {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
    Mat3 nearest = Mat3::Identity();
    double largest_trace = -4;
    for (const auto& order : orders) {
        for (int signs = 0; signs < 4; ++signs) {
            Mat3 axes;
            Vec3 moments;
            for (int i = 0; i < 3; ++i) {
                moments(i) = solver.eigenvalues()(order[i]);
                axes.col(i) = solver.eigenvectors().col(order[i]) * ((signs >> i & 1) != 0 ? -1 : 1);
            }
            axes.col(2) *= axes.determinant() < 0 ? -1 : 1;
            align_equal_moments(axes, moments);
            // The margin keeps rounding from choosing between frames that are equally near.
            if (axes.trace() > largest_trace + 1e-9) {
                largest_trace = axes.trace();
                nearest = axes;
            }
        }
    }
    const Vec3 moments = (nearest.transpose() * inertia * nearest).diagonal();
    return {moments, Quat(nearest).normalized()};
}

}  // namespace scree

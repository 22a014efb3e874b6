#include "flatten_faces.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/SparseCholesky>

#include "face_plane.hpp"

namespace scree {

namespace {

using Loop = std::vector<int>;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// Planes of the faces that have more than three vertices, and which of them meet at each vertex.
class Incidences {
  public:
    Incidences(std::vector<Vec3>& points, const std::vector<Loop>& loops)
        : points_(points), at_(points.size()) {
        for (const Loop& loop : loops) {
            if (loop.size() > 3) {
                for (const int v : loop) {
                    at_[v].push_back(static_cast<int>(planes_.size()));
                }
                planes_.push_back(plane_of(points, loop));
            }
        }
    }

    [[nodiscard]] double largest_height() const {
        double largest = 0;
        for (std::size_t v = 0; v < points_.size(); ++v) {
            for (const int f : at_[v]) {
                largest = std::max(largest, std::abs(planes_[f].height(points_[v])));
            }
        }
        return largest;
    }

    /// One Newton step. Each vertex answers the planes' moves by its own least move onto them all; what is
    /// left is a sparse, symmetric, positive definite system for the planes.
    bool step() {
        const auto unknowns = static_cast<Eigen::Index>(3 * planes_.size());
        Eigen::SparseMatrix<double> matrix(unknowns, unknowns);
        Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns);
        std::vector<Eigen::Triplet<double>> entries;
        for (std::size_t v = 0; v < points_.size(); ++v) {
            add_vertex(v, entries, right);
        }
        matrix.setFromTriplets(entries.begin(), entries.end());
        const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
        if (solver.info() != Eigen::Success) {
            return false;
        }
        const Eigen::VectorXd moves = solver.solve(right);
        if (!moves.allFinite()) {
            return false;
        }
        for (std::size_t v = 0; v < points_.size(); ++v) {
            move_vertex(v, moves);
        }
        for (std::size_t f = 0; f < planes_.size(); ++f) {
            planes_[f].move(moves.segment<3>(static_cast<Eigen::Index>(3 * f)));
        }
        return true;
    }

  private:
    struct Vertex {
        Rows normals;
        Rows slopes;
        Eigen::VectorXd heights;
        Eigen::MatrixXd stiffness;  // (N Nᵀ + small)⁻¹
    };

    /// The small term lets more than three planes meet: a vertex that cannot follow pulls at the planes.
    [[nodiscard]] Vertex vertex(std::size_t v) const {
        constexpr double slack = 1e-9;
        const auto count = static_cast<Eigen::Index>(at_[v].size());
        Vertex result{Rows(count, 3), Rows(count, 3), Eigen::VectorXd(count), {}};
        for (Eigen::Index i = 0; i < count; ++i) {
            const FacePlane& plane = planes_[at_[v][i]];
            result.normals.row(i) = plane.normal;
            result.slopes.row(i) = plane.slope(points_[v]);
            result.heights(i) = plane.height(points_[v]);
        }
        Eigen::MatrixXd gram = result.normals * result.normals.transpose();
        gram.diagonal().array() += slack;
        result.stiffness = gram.ldlt().solve(Eigen::MatrixXd::Identity(count, count));
        return result;
    }

    void add_vertex(std::size_t v, std::vector<Eigen::Triplet<double>>& entries,
                    Eigen::VectorXd& right) const {
        if (at_[v].empty()) {
            return;
        }
        const Vertex local = vertex(v);
        const Eigen::VectorXd pull = local.stiffness * local.heights;
        for (std::size_t i = 0; i < at_[v].size(); ++i) {
            const int row = 3 * at_[v][i];
            const auto r = static_cast<Eigen::Index>(i);
            right.segment<3>(row) -= pull(r) * local.slopes.row(r).transpose();
            for (std::size_t j = 0; j < at_[v].size(); ++j) {
                const int column = 3 * at_[v][j];
                const auto c = static_cast<Eigen::Index>(j);
                const Mat3 block =
                    local.stiffness(r, c) * local.slopes.row(r).transpose() * local.slopes.row(c);
                for (int k = 0; k < 9; ++k) {
                    entries.emplace_back(row + k / 3, column + k % 3, block(k / 3, k % 3));
                }
            }
        }
    }

    void move_vertex(std::size_t v, const Eigen::VectorXd& moves) {
        if (at_[v].empty()) {
            return;
        }
        const Vertex local = vertex(v);
        Eigen::VectorXd heights = local.heights;
        for (std::size_t i = 0; i < at_[v].size(); ++i) {
            heights(static_cast<Eigen::Index>(i)) += local.slopes.row(static_cast<Eigen::Index>(i)) *
                                                     moves.segment<3>(Eigen::Index{3} * at_[v][i]);
        }
        points_[v] -= local.normals.transpose() * (local.stiffness * heights);
    }

    std::vector<Vec3>& points_;
    std::vector<std::vector<int>> at_;
    std::vector<FacePlane> planes_;
};

}  // namespace

double unevenness(const std::vector<Vec3>& points, const Loop& loop) {
    const FacePlane plane = plane_of(points, loop);
    double largest = 0;
    for (const int v : loop) {
        largest = std::max(largest, std::abs(plane.height(points[v])));
    }
    return largest;
}

std::vector<Vec3> flattened(std::vector<Vec3> points, const std::vector<Loop>& loops) {
    constexpr int most_steps = 20;
    constexpr double flat = 4e-16;         // what rounding leaves at unit size
    constexpr double flat_enough = 1e-13;  // planar as given
    const bool planar = std::all_of(loops.begin(), loops.end(), [&](const Loop& loop) {
        return loop.size() <= 3 || unevenness(points, loop) <= flat_enough;
    });
    if (planar) {
        return points;
    }
    Incidences incidences(points, loops);
    double before = std::numeric_limits<double>::infinity();
    for (int i = 0; i < most_steps; ++i) {
        const double now = incidences.largest_height();
        if (now <= flat || (now < flat_enough && now > before / 2) || !incidences.step()) {
            break;
        }
        before = now;
    }
    return points;
}

}  // namespace scree

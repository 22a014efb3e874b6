#include <scree/dynamics/jacobian.hpp>

namespace scree {

namespace {

constexpr std::size_t most_dense_bodies = 8;  // a dense factorisation is as fast up to here

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

// dL/dω: L = I(q) ω, and I turns with q.
Mat3 turning_inertia(const Body& body, const TrialBody& trial) {
    const Mat3 inertia = world_inertia(body, trial.pose.orientation);
    return inertia +
           (inertia * cross_matrix(trial.spin) - cross_matrix(inertia * trial.spin)) * trial.turn_rate;
}

// Of the equations of a body that a contact has part in, only what gets through its restraint.
void restrain(const Body& body, Mat6& block) {
    if (body.restraint != nullptr) {
        block.topRows<3>() = body.restraint->along.asDiagonal() * block.topRows<3>();
        block.bottomRows<3>() = body.restraint->around.asDiagonal() * block.bottomRows<3>();
    }
}

Mat6 stacked(const Mat39& force, const Mat39& moment, int column) {
    Mat6 block;
    block << force.leftCols<3>(), force.middleCols<3>(column), moment.leftCols<3>(),
        moment.middleCols<3>(column);
    return block;
}

}  // namespace

double held_inertia(const Body& body) {
    return body.inertia.mean();
}

Mat6 inertia_block(const Body& body, const TrialBody& trial, double beta_h) {
    Mat6 block = Mat6::Zero();
    block.topLeftCorner<3, 3>() = body.mass * Mat3::Identity();
    block.bottomRightCorner<3, 3>() = turning_inertia(body, trial);
    if (const Restraint* restraint = body.restraint) {
        block.topRows<3>() *= 1 + beta_h * restraint->slowing;
        block.bottomRows<3>() *= 1 + beta_h * restraint->turning_down;
        for (int axis = 0; axis < 3; ++axis) {
            if (restraint->held(axis)) {
                block.row(3 + axis).setZero();
                block(3 + axis, 3 + axis) = held_inertia(body);
            }
        }
    }
    return block;
}

void Jacobian::assemble(std::span<const Body> bodies, std::span<const TrialBody> trial,
                        std::span<const Contact> contacts, std::span<const ContactResult> results,
                        double beta_h) {
    islands_.find(bodies, contacts, results);
    blocks_.clear();
    held_.resize(std::max(held_.size(), islands_.count()));
    for (auto& held : held_) {
        held.clear();
    }
    diagonal_.resize(bodies.size());
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (bodies[b].dynamic()) {
            diagonal_[b] = inertia_block(bodies[b], trial[b], beta_h);
        }
    }
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        if (results[i].law.state != ContactState::open) {
            add_contact(contacts[i], results[i], bodies, beta_h);
        }
    }
}

// Residual rows of A: −βh (F, M_A); of B: −βh (−F, M_B). Columns: A's velocity as it is in the nine unknowns,
// B's with the opposite sign.
void Jacobian::add_contact(const Contact& contact, const ContactResult& result, std::span<const Body> bodies,
                           double beta_h) {
    const int a = contact.a.body;
    const int b = contact.b.body;
    const Mat39 force = -beta_h * result.law.force_rate;
    const Mat39 moment_a = -beta_h * result.moment_a_rate;
    const Mat39 moment_b = -beta_h * result.moment_b_rate;
    const bool both = bodies[at(a)].dynamic() && bodies[at(b)].dynamic();
    if (bodies[at(a)].dynamic()) {
        Mat6 block = stacked(force, moment_a, 3);
        restrain(bodies[at(a)], block);
        diagonal_[at(a)] += block;
    }
    if (bodies[at(b)].dynamic()) {
        Mat6 block = stacked(-force, moment_b, 6);
        block.leftCols<3>() *= -1;
        restrain(bodies[at(b)], block);
        diagonal_[at(b)] += block;
    }
    if (!both) {
        return;
    }
    auto& held = held_[at(islands_.island_of(a))];
    Mat6 a_by_b = stacked(force, moment_a, 6);
    a_by_b.leftCols<3>() *= -1;
    restrain(bodies[at(a)], a_by_b);
    Mat6 b_by_a = stacked(-force, moment_b, 3);
    restrain(bodies[at(b)], b_by_a);
    held.push_back(blocks_.size());
    blocks_.push_back({a, b, a_by_b});
    held.push_back(blocks_.size());
    blocks_.push_back({b, a, b_by_a});
}

bool Jacobian::factorize() {
    if (solvers_.size() < islands_.count()) {
        solvers_.resize(islands_.count());
    }
    bool good = true;
    for (std::size_t i = 0; i < islands_.count(); ++i) {
        IslandSolver& solver = solvers_[i];
        solver.sparse = islands_.bodies(i).size() > most_dense_bodies;
        good = good && (solver.sparse ? factorize_sparse(solver, i) : factorize_dense(solver, i));
    }
    return good;
}

bool Jacobian::factorize_dense(IslandSolver& solver, std::size_t island) {
    const auto members = islands_.bodies(island);
    const auto size = static_cast<Eigen::Index>(6 * members.size());
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
    for (std::size_t i = 0; i < members.size(); ++i) {
        const auto place = static_cast<Eigen::Index>(6 * i);
        matrix.block<6, 6>(place, place) = diagonal_[at(members[i])];
    }
    for (const std::size_t k : held_[island]) {
        const Block& block = blocks_[k];
        matrix.block<6, 6>(6 * islands_.place_of(block.row), 6 * islands_.place_of(block.column)) +=
            block.value;
    }
    solver.dense_lu.compute(matrix);
    const auto pivots = solver.dense_lu.matrixLU().diagonal();
    return pivots.allFinite() && (pivots.array() != 0).all();
}

bool Jacobian::factorize_sparse(IslandSolver& solver, std::size_t island) {
    const auto members = islands_.bodies(island);
    const auto size = static_cast<Eigen::Index>(6 * members.size());
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(36 * (members.size() + held_[island].size()));
    const auto add = [&](int row, int column, const Mat6& value) {
        for (int c = 0; c < 6; ++c) {
            for (int r = 0; r < 6; ++r) {
                entries.emplace_back(6 * row + r, 6 * column + c, value(r, c));
            }
        }
    };
    std::vector<int> pattern(members.begin(), members.end());
    for (std::size_t i = 0; i < members.size(); ++i) {
        add(static_cast<int>(i), static_cast<int>(i), diagonal_[at(members[i])]);
    }
    for (const std::size_t k : held_[island]) {
        const Block& block = blocks_[k];
        add(islands_.place_of(block.row), islands_.place_of(block.column), block.value);
        pattern.push_back(block.row);
        pattern.push_back(block.column);
    }
    solver.matrix.resize(size, size);
    solver.matrix.setFromTriplets(entries.begin(), entries.end());
    if (!Eigen::Map<const Eigen::VectorXd>(solver.matrix.valuePtr(), solver.matrix.nonZeros()).allFinite()) {
        return false;
    }
    if (!solver.sparse_lu) {
        solver.sparse_lu = std::make_unique<SparseSolver>();
        solver.sparse_lu->isSymmetric(true);
        solver.sparse_lu->setPivotThreshold(0.1);
    }
    if (pattern != solver.pattern) {
        solver.sparse_lu->analyzePattern(solver.matrix);
        solver.pattern = std::move(pattern);
    }
    solver.sparse_lu->factorize(solver.matrix);
    return solver.sparse_lu->info() == Eigen::Success;
}

void Jacobian::solve(Eigen::VectorXd& x) const {
    for (std::size_t b = 0; b < diagonal_.size(); ++b) {
        if (islands_.island_of(static_cast<int>(b)) < 0) {
            x.segment<6>(static_cast<Eigen::Index>(6 * b)).setZero();
        }
    }
    for (std::size_t i = 0; i < islands_.count(); ++i) {
        const auto members = islands_.bodies(i);
        const IslandSolver& solver = solvers_[i];
        part_.resize(static_cast<Eigen::Index>(6 * members.size()));
        for (std::size_t m = 0; m < members.size(); ++m) {
            part_.segment<6>(static_cast<Eigen::Index>(6 * m)) = x.segment<6>(6 * members[m]);
        }
        const Eigen::VectorXd solution = solver.sparse ? Eigen::VectorXd(solver.sparse_lu->solve(part_))
                                                       : Eigen::VectorXd(solver.dense_lu.solve(part_));
        for (std::size_t m = 0; m < members.size(); ++m) {
            x.segment<6>(6 * members[m]) = solution.segment<6>(static_cast<Eigen::Index>(6 * m));
        }
    }
}

Eigen::MatrixXd Jacobian::dense(std::size_t bodies) const {
    const auto size = static_cast<Eigen::Index>(6 * bodies);
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(size, size);
    for (int b = 0; b < static_cast<int>(bodies); ++b) {
        if (islands_.island_of(b) >= 0) {
            matrix.block<6, 6>(6 * b, 6 * b) = diagonal_[at(b)];
        }
    }
    for (const Block& block : blocks_) {
        matrix.block<6, 6>(6 * block.row, 6 * block.column) += block.value;
    }
    return matrix;
}

}  // namespace scree

#include <scree/dynamics/jacobian.hpp>

namespace scree {

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

// dL/dω: L = I(q) ω, and I turns with q.
Mat3 turning_inertia(const Body& body, const TrialBody& trial) {
    const Mat3 inertia = world_inertia(body, trial.pose.orientation);
    return inertia +
           (inertia * cross_matrix(trial.spin) - cross_matrix(inertia * trial.spin)) * trial.turn_rate;
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

void Jacobian::number(std::span<const Body> bodies) {
    place_.assign(bodies.size(), -1);
    scale_.clear();
    restraint_.clear();
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (bodies[b].dynamic()) {
            place_[b] = static_cast<int>(scale_.size());
            scale_.emplace_back(bodies[b].mass, bodies[b].mass * bodies[b].radius);
            restraint_.push_back(bodies[b].restraint);
        }
    }
}

void Jacobian::assemble(std::span<const Body> bodies, std::span<const TrialBody> trial,
                        std::span<const Contact> contacts, std::span<const ContactResult> results,
                        double beta_h) {
    number(bodies);
    matrix_.clear(static_cast<int>(scale_.size()));
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (place_[b] >= 0) {
            add(place_[b], place_[b], inertia_block(bodies[b], trial[b], beta_h));
        }
    }
    for (std::size_t i = 0; i < contacts.size(); ++i) {
        if (results[i].law.state != ContactState::open) {
            add_contact(contacts[i], results[i], beta_h);
        }
    }
    matrix_.finish();
}

// Residual rows of A: −βh (F, M_A); of B: −βh (−F, M_B). Columns: A's velocity as it is in the nine unknowns,
// B's with the opposite sign.
void Jacobian::add_contact(const Contact& contact, const ContactResult& result, double beta_h) {
    const int a = place_[at(contact.a.body)];
    const int b = place_[at(contact.b.body)];
    const Mat39 force = -beta_h * result.law.force_rate;
    const Mat39 moment_a = -beta_h * result.moment_a_rate;
    const Mat39 moment_b = -beta_h * result.moment_b_rate;
    const auto by_b = [](Mat6 block) {
        block.leftCols<3>() *= -1;
        return block;
    };
    if (a >= 0) {
        add_force(a, a, stacked(force, moment_a, 3));
    }
    if (b >= 0) {
        add_force(b, b, by_b(stacked(-force, moment_b, 6)));
    }
    if (a >= 0 && b >= 0) {
        add_force(a, b, by_b(stacked(force, moment_a, 6)));
        add_force(b, a, stacked(-force, moment_b, 3));
    }
}

// What gets through a body's restraint of it.
void Jacobian::add_force(int row, int column, Mat6 block) {
    if (const Restraint* restraint = restraint_[at(row)]) {
        block.topRows<3>() = restraint->along.asDiagonal() * block.topRows<3>();
        block.bottomRows<3>() = restraint->around.asDiagonal() * block.bottomRows<3>();
    }
    add(row, column, block);
}

void Jacobian::add(int row, int column, const Mat6& block) {
    Mat6 scaled = block;
    scaled.topRows<3>() /= scale_[at(row)].first;
    scaled.bottomRows<3>() /= scale_[at(row)].second;
    matrix_.add(row, column, scaled);
}

bool Jacobian::solve(Eigen::VectorXd& x) {
    part_.resize(static_cast<Eigen::Index>(6 * scale_.size()));
    for (std::size_t b = 0; b < place_.size(); ++b) {
        const auto row = static_cast<Eigen::Index>(6 * b);
        if (place_[b] >= 0) {
            const auto [mass, moment] = scale_[at(place_[b])];
            part_.segment<3>(6 * place_[b]) = x.segment<3>(row) / mass;
            part_.segment<3>(6 * place_[b] + 3) = x.segment<3>(row + 3) / moment;
        }
    }
    if (!solver_.solve(part_)) {
        return false;
    }
    for (std::size_t b = 0; b < place_.size(); ++b) {
        auto segment = x.segment<6>(static_cast<Eigen::Index>(6 * b));
        if (place_[b] >= 0) {
            segment = part_.segment<6>(6 * place_[b]);
        } else {
            segment.setZero();
        }
    }
    return true;
}

Eigen::MatrixXd Jacobian::dense() const {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(6 * place_.size()),
                                                   static_cast<Eigen::Index>(6 * place_.size()));
    std::vector<int> body;
    for (std::size_t b = 0; b < place_.size(); ++b) {
        if (place_[b] >= 0) {
            body.push_back(static_cast<int>(b));
        }
    }
    for (int row = 0; row < matrix_.size(); ++row) {
        for (std::size_t at_place = matrix_.begin(row); at_place < matrix_.end(row); ++at_place) {
            Mat6 block = matrix_.block(at_place);
            block.topRows<3>() *= scale_[at(row)].first;
            block.bottomRows<3>() *= scale_[at(row)].second;
            matrix.block<6, 6>(6 * body[at(row)], 6 * body[at(matrix_.column(at_place))]) = block;
        }
    }
    return matrix;
}

}  // namespace scree

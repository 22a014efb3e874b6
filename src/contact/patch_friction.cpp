#include <scree/contact/patch_friction.hpp>

#include <scree/contact/carried_force.hpp>

#include "tangential_force.hpp"

namespace scree {

namespace {

/// The patch's axes, e₁, e₂ = n × e₁ and n, and the motion in them.
struct PatchMotion {
    Mat3 axes;                 // columns
    Vec3 slip = Vec3::Zero();  // of A against B at the centroid along e₁ and e₂ [m/s], and about n [rad/s]
    Mat39 second_rate, slip_rate;

    PatchMotion(const ContactInput& in, const PatchAxis& axis) {
        const Vec3& n = in.geometry.normal;
        axes << axis.axis, n.cross(axis.axis), n;
        slip << axes.col(0).dot(in.motion.velocity), axes.col(1).dot(in.motion.velocity),
            n.dot(in.motion.spin);
        if (in.rates == nullptr) {
            return;
        }
        second_rate = cross_matrix(n) * axis.rate - cross_matrix(axis.axis) * in.rates->normal;
        slip_rate.row(0) =
            axes.col(0).transpose() * in.rates->velocity + in.motion.velocity.transpose() * axis.rate;
        slip_rate.row(1) =
            axes.col(1).transpose() * in.rates->velocity + in.motion.velocity.transpose() * second_rate;
        slip_rate.row(2) = n.transpose() * in.rates->spin + in.motion.spin.transpose() * in.rates->normal;
    }
};

/// What the stored forces of the past count for at present.
struct PatchPast {
    struct Turn {
        double weight = 0, cosine = 1, sine = 0;  // of the record's axes against the present ones
        Row9 rate;                                // of that angle
    };
    std::array<Turn, highest_order> turns;
    std::size_t count = 0;
    double share = 1;  // of their sum, where the stiffness has fallen
    Row9 share_rate;

    PatchPast(const ContactInput& in, const LawOptions& options, const PatchAxis& axis,
              const PatchMotion& motion, const TangentialConstants& constants) {
        if (axis.fresh) {
            return;
        }
        count = in.step.formula.past.size() <= in.history.patch_age ? in.step.formula.past.size() : 0;
        const auto& past = in.history.past;
        double kept = 1;
        for (std::size_t j = 0; j < count; ++j) {
            kept *= j > 0 ? share_kept(past[j - 1].stiffness, past[j].stiffness) : 1;
            turns[j].weight = in.step.formula.past[j] * kept;
            if (j > 0) {
                find_turn(in, options, axis, motion, j);
            }
        }
        const double before = past[0].stiffness;
        share = share_kept(constants.stiffness, before);
        if (in.rates != nullptr) {
            share_rate = share < 1 ? Row9(constants.stiffness_rate / before) : Row9(Row9::Zero());
        }
    }

    /// Of one cell, before the share.
    [[nodiscard]] Vec3 sum(const ContactHistory& history, std::size_t cell) const {
        Vec3 force = Vec3::Zero();
        for (std::size_t j = 0; j < count; ++j) {
            force += turns[j].weight * turned(turns[j], history.patch[j].force[cell]);
        }
        return force;
    }
    /// Its derivative by the angle of the j-th record.
    [[nodiscard]] Vec3 by_angle(const ContactHistory& history, std::size_t j, std::size_t cell) const {
        const Vec3 force = turned(turns[j], history.patch[j].force[cell]);
        return turns[j].weight * share * Vec3(-force.y(), force.x(), 0);
    }

  private:
    static Vec3 turned(const Turn& turn, const Vec3& force) {
        return {turn.cosine * force.x() - turn.sine * force.y(),
                turn.sine * force.x() + turn.cosine * force.y(), force.z()};
    }

    // Each record straight from its own plane; the axes are those of the latest one.
    void find_turn(const ContactInput& in, const LawOptions& options, const PatchAxis& axis,
                   const PatchMotion& motion, std::size_t j) {
        const FrictionRecord record{.force = in.history.patch[j].axis, .normal = in.history.past[j].normal};
        const CarriedForce own = carry(record, in.geometry.normal, in.step.turn_a[j], in.step.turn_b[j],
                                       options.co_rotation, in.rates);
        if (own.lost_direction) {
            return;
        }
        turns[j].cosine = own.force.dot(motion.axes.col(0));
        turns[j].sine = own.force.dot(motion.axes.col(1));
        if (in.rates != nullptr) {
            const Vec3 across = in.geometry.normal.cross(own.force);
            turns[j].rate = across.transpose() * own.rate - motion.axes.col(1).transpose() * axis.rate;
        }
    }
};

/// All cells together: force along the axes and moment about n, and its derivative.
struct PatchSum {
    Vec3 force = Vec3::Zero();
    Mat3 by_slip = Mat3::Zero();
    Vec3 by_pressing = Vec3::Zero(), by_stiffness = Vec3::Zero(), by_damping = Vec3::Zero();
    Vec3 by_share = Vec3::Zero();
    std::array<Vec3, highest_order> by_angle;
    double spring_power = 0, power = 0, energy = 0;

    PatchSum() { by_angle.fill(Vec3::Zero()); }
};

/// A force of a cell with its derivative by itself and by the pressing force.
struct CellForce {
    Vec3 force = Vec3::Zero();
    Mat3 by_force = Mat3::Identity();
    Vec3 by_pressing = Vec3::Zero();

    /// Scales what is larger than `most` back to `left`, both friction coefficients. Returns true when it
    /// was.
    bool cut_off(double most, double left, double pressing, bool rates) {
        const double size = force.norm();
        if (!(size > most * pressing)) {
            return false;
        }
        const Vec3 direction = force / size;
        force = left * pressing * direction;
        if (rates) {
            const double ratio = left * pressing / size;
            const auto project = [&](const auto& m) {
                return (ratio * (m - direction * (direction.transpose() * m))).eval();
            };
            by_force = project(by_force);
            by_pressing = project(by_pressing) + left * direction;
        }
        return true;
    }
};

/// One law for all cells of a contact.
template <FrictionLaw friction>
class Cells {
  public:
    Cells(const ContactInput& in, const PressingForce& pressing, const PatchMotion& motion,
          const PatchPast& past, const TangentialConstants& constants)
        : in_(in), pressing_(pressing), motion_(motion), past_(past), constants_(constants) {}

    void add(std::size_t cell, PatchRecord& record, PatchSum& sum) const {
        const Mat3 motion = motion_of(cell);
        const Vec3 slip = motion * motion_.slip;
        const double share = in_.cells->share[cell];
        CellForce force;
        double most = in_.pair.kinetic_friction;
        if constexpr (has_spring) {
            const bool held = !(in_.history.patch_age > 0 && in_.history.patch[0].slipping[cell]);
            most = held ? in_.pair.friction : most;
            const Vec3 carried = past_.sum(in_.history, cell);
            force.force = past_.share * carried - stretch_ * slip;
            if (force.cut_off(most, in_.pair.kinetic_friction, pressing_.size, in_.rates != nullptr)) {
                record.slipping.set(cell);
                most = in_.pair.kinetic_friction;
            }
            record.force[cell] = force.force;
            sum.spring_power -= share * force.force.dot(slip);
            sum.energy += share * stored_energy(force.force, constants_);
        }
        const Mat3 by_carried = force.by_force;
        force.force -= constants_.damping * slip;
        force.by_force.setIdentity();
        Vec3 by_pressing = force.by_pressing;
        force.by_pressing.setZero();
        const bool limited = force.cut_off(most, most, pressing_.size, in_.rates != nullptr);
        if (!has_spring && limited) {
            record.slipping.set(cell);
        }
        sum.power -= share * force.force.dot(slip);
        sum.force += share * (motion.transpose() * force.force);
        if (in_.rates != nullptr) {
            by_pressing = force.by_force * by_pressing + force.by_pressing;
            add_rates(cell, share * motion.transpose(), motion, slip, force.by_force,
                      force.by_force * by_carried, by_pressing, sum);
        }
    }

  private:
    static constexpr bool has_spring = friction != FrictionLaw::viscous;

    // From the motion in the patch's axes to the slip of a cell, its turning over its lever last.
    [[nodiscard]] Mat3 motion_of(std::size_t cell) const {
        const Vec2& at = in_.cells->at[cell];
        Mat3 motion = Mat3::Identity();
        motion.col(2) << -at.y(), at.x(), in_.cells->lever[cell];
        return motion;
    }

    // `collect` takes a cell's force to the sum.
    void add_rates(std::size_t cell, const Mat3& collect, const Mat3& motion, const Vec3& slip,
                   const Mat3& by_damper, const Mat3& by_spring, const Vec3& by_pressing,
                   PatchSum& sum) const {
        const Mat3 damper = collect * by_damper;
        sum.by_pressing += collect * by_pressing;
        sum.by_slip -= constants_.damping * damper * motion;
        sum.by_damping -= damper * slip;
        if constexpr (has_spring) {
            const Mat3 spring = collect * by_spring;
            sum.by_slip -= stretch_ * spring * motion;
            sum.by_stiffness -= in_.step.formula.beta_h * spring * slip;
            if (past_.share < 1) {
                sum.by_share += spring * past_.sum(in_.history, cell);
            }
            for (std::size_t j = 1; j < past_.count; ++j) {
                sum.by_angle[j] += spring * past_.by_angle(in_.history, j, cell);
            }
        }
    }

    const ContactInput& in_;
    const PressingForce& pressing_;
    const PatchMotion& motion_;
    const PatchPast& past_;
    const TangentialConstants& constants_;
    double stretch_ = in_.step.formula.beta_h * constants_.stiffness;
};

void apply(const ContactInput& in, const PressingForce& pressing, const PatchAxis& axis,
           const PatchMotion& motion, const PatchPast& past, const TangentialConstants& constants,
           const PatchSum& sum, ContactForce& out) {
    const Vec3& n = in.geometry.normal;
    out.force += sum.force.x() * motion.axes.col(0) + sum.force.y() * motion.axes.col(1);
    out.moment += sum.force.z() * n;
    if (in.rates == nullptr) {
        return;
    }
    Mat39 rate = sum.by_slip * motion.slip_rate;
    rate.noalias() += sum.by_pressing * pressing.rate;
    if (constants.vary) {
        rate.noalias() += sum.by_stiffness * constants.stiffness_rate;
        rate.noalias() += sum.by_damping * constants.damping_rate;
    }
    if (past.share < 1) {
        rate.noalias() += sum.by_share * past.share_rate;
    }
    for (std::size_t j = 1; j < past.count; ++j) {
        rate.noalias() += sum.by_angle[j] * past.turns[j].rate;
    }
    out.force_rate.noalias() += motion.axes.leftCols<2>() * rate.topRows<2>();
    out.force_rate += sum.force.x() * axis.rate + sum.force.y() * motion.second_rate;
    out.moment_rate.noalias() += n * rate.row(2);
    out.moment_rate += sum.force.z() * in.rates->normal;
}

}  // namespace

PatchAxis patch_axis(const ContactHistory& history, const Vec3& normal, const Vec3& otherwise,
                     const FrictionStep& step, bool co_rotation, const MotionRates* rates) {
    PatchAxis axis;
    if (history.patch_age > 0) {
        const FrictionRecord record{.force = history.patch[0].axis, .normal = history.past[0].normal};
        const CarriedForce carried =
            carry(record, normal, step.turn_a[0], step.turn_b[0], co_rotation, rates);
        if (!carried.lost_direction) {
            axis.axis = carried.force;
            axis.rate = carried.rate;
            return axis;
        }
    }
    axis.fresh = true;
    axis.axis = (otherwise - otherwise.dot(normal) * normal).normalized();
    if (rates != nullptr) {
        axis.rate = -normal * (axis.axis.transpose() * rates->normal);
    }
    return axis;
}

template <FrictionLaw friction>
void add_patch_friction(const ContactInput& in, const PressingForce& pressing, const LawOptions& options,
                        ContactForce& out) {
    const PatchAxis axis =
        patch_axis(in.history, in.geometry.normal, in.cells->axis, in.step, options.co_rotation, in.rates);
    const PatchMotion motion(in, axis);
    Slip slip = sliding(in);
    add_spin(in, slip);
    TangentialConstants constants = tangential_constants(in, options, slip);
    const PatchPast past(in, options, axis, motion, constants);
    out.trial.normal = in.geometry.normal;
    out.trial.stiffness = constants.stiffness;
    cap(in, constants);

    PatchRecord& record = out.cells.emplace_back();
    record.axis = axis.axis;
    PatchSum sum;
    const Cells<friction> cells(in, pressing, motion, past, constants);
    for (std::size_t cell = 0; cell < PatchCells::count; ++cell) {
        cells.add(cell, record, sum);
    }
    out.lost_direction |= axis.fresh && in.history.patch_age > 0;
    out.state = record.slipping.all() ? ContactState::slip : ContactState::stick;
    out.trial.slipping = record.slipping.all();
    out.tangential_energy = sum.energy;
    if constexpr (friction == FrictionLaw::viscous) {
        // At the limit it is Coulomb's friction.
        (record.slipping.any() ? out.power.tangential : out.power.tangential_damping) = sum.power;
    } else {
        out.power.tangential = sum.spring_power;
        out.power.tangential_damping = sum.power - sum.spring_power;
    }
    apply(in, pressing, axis, motion, past, constants, sum, out);
}

template void add_patch_friction<FrictionLaw::cundall_strack>(const ContactInput&, const PressingForce&,
                                                              const LawOptions&, ContactForce&);
template void add_patch_friction<FrictionLaw::viscous>(const ContactInput&, const PressingForce&,
                                                       const LawOptions&, ContactForce&);

}  // namespace scree

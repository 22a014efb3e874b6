#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <tests/support/contact_case.hpp>

namespace scree::test {

/// One way to choose the law.
struct LawCombination {
    FrictionLaw friction = FrictionLaw::cundall_strack;
    LawOptions options;
    bool torsion = true;

    [[nodiscard]] std::string name() const {
        const char* const frictions[] = {"cundall_strack", "cundall_strack_2d", "viscous", "none"};
        const char* const stiffnesses[] = {"length", "patch", "no_length"};
        const char* const masses[] = {"point", "round", "exact"};
        return std::string(frictions[static_cast<int>(friction)]) + ", " +
               stiffnesses[static_cast<int>(options.tangential_stiffness)] + ", " +
               masses[static_cast<int>(options.reduced_mass)] + (torsion ? ", torsion" : "") +
               (options.co_rotation ? ", co-rotation" : "") +
               (options.damping == DampingPlace::patch ? ", patch damping" : "") +
               (options.normal_damping == NormalDamping::patch ? ", one ratio" : "");
    }
};

/// All of them that have friction.
inline std::vector<LawCombination> law_combinations() {
    std::vector<LawCombination> all;
    for (const auto friction :
         {FrictionLaw::cundall_strack, FrictionLaw::cundall_strack_2d, FrictionLaw::viscous}) {
        for (const auto stiffness :
             {TangentialStiffness::length, TangentialStiffness::patch, TangentialStiffness::no_length}) {
            for (const auto mass : {ReducedMass::point, ReducedMass::round, ReducedMass::exact}) {
                for (const auto damping : {DampingPlace::patch, DampingPlace::centroid}) {
                    const auto normal_damping =
                        all.size() / 4 % 3 == 0 ? NormalDamping::patch : NormalDamping::length;
                    for (const bool torsion : {true, false}) {
                        for (const bool co_rotation : {true, false}) {
                            all.push_back(
                                {friction,
                                 {Elasticity::volume, damping, normal_damping, stiffness, mass, co_rotation},
                                 torsion});
                        }
                    }
                }
            }
        }
    }
    return all;
}

/// A random contact under that law, its motion such that about as many stick as slip.
inline ContactCase random_case(Random& random, const LawCombination& law, bool on_cells = false) {
    ContactCase c = random_case(random, on_cells);
    c.options = law.options;
    c.pair.torsion = law.torsion;
    const bool viscous = law.friction == FrictionLaw::viscous;
    double softer = random.uniform(0.3, 3);
    if (viscous) {
        softer *= c.pair.tangential_stiffness * c.beta_h / c.pair.tangential_damping;
    }
    if (law.options.tangential_stiffness == TangentialStiffness::patch) {
        const double share = c.patch_stiffness() / c.pair.tangential_stiffness;
        softer /= viscous ? std::sqrt(share) : share;
    } else if (law.options.tangential_stiffness == TangentialStiffness::no_length && !viscous) {
        softer *= c.pair.length;
    }
    c.motion = {softer * c.motion.velocity, softer * c.motion.spin};
    for (FrictionRecord& record : c.history.past) {
        record.force *= 0.5;
    }
    for (PatchRecord& record : c.history.patch) {
        for (Vec3& force : record.force) {
            force *= 0.5;
        }
    }
    if (random.uniform() < 0.5) {
        c.pair.rolling_friction = 0.3;
        const double moment = 0.3 * c.normal_force();
        for (FrictionRecord& record : c.history.past) {
            record.rolling = moment * record.normal.cross(random.vector());
        }
    }
    c.pair.cohesion = random.uniform() < 0.3 ? 0.5 * c.normal_force() : 0;
    c.pair.kinetic_friction = random.uniform(0.5, 1) * c.pair.friction;
    c.history.past[0].slipping = random.uniform() < 0.5;
    return c;
}

}  // namespace scree::test

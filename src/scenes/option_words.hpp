#pragma once

#include <scree/scenes/scene_options.hpp>

#include "fields.hpp"

namespace scree {

// The words of a scene file's options.
inline constexpr Choice<NormalLaw> normal_laws[] = {
    {"volume", NormalLaw::volume}, {"manifold", NormalLaw::manifold}, {"energy", NormalLaw::energy}};
inline constexpr Choice<FrictionLaw> friction_laws[] = {{"cundall_strack", FrictionLaw::cundall_strack},
                                                        {"cundall_strack_2d", FrictionLaw::cundall_strack_2d},
                                                        {"viscous", FrictionLaw::viscous},
                                                        {"none", FrictionLaw::none}};
inline constexpr Choice<DampingPlace> damping_places[] = {{"patch", DampingPlace::patch},
                                                          {"centroid", DampingPlace::centroid}};
inline constexpr Choice<NormalDamping> normal_dampings[] = {{"length", NormalDamping::length},
                                                            {"patch", NormalDamping::patch}};
inline constexpr Choice<TangentialStiffness> tangential_stiffnesses[] = {
    {"length", TangentialStiffness::length},
    {"patch", TangentialStiffness::patch},
    {"no_length", TangentialStiffness::no_length}};
inline constexpr Choice<ReducedMass> reduced_masses[] = {
    {"point", ReducedMass::point}, {"round", ReducedMass::round}, {"exact", ReducedMass::exact}};

inline constexpr Choice<SteppingMethod> stepping_methods[] = {
    {"bdf", SteppingMethod::bdf},
    {"verlet", SteppingMethod::verlet},
    {"symplectic_euler", SteppingMethod::symplectic_euler},
    {"bullet", SteppingMethod::bullet}};
inline constexpr Choice<Solver> solver_choices[] = {
    {"auto", Solver::automatic}, {"newton", Solver::newton}, {"fixed_point", Solver::fixed_point}};

/// The word of a table for a value that it has.
template <class E, std::size_t count>
std::string_view word_of(const Choice<E> (&choices)[count], E value) {
    for (const Choice<E>& each : choices) {
        if (each.value == value) {
            return each.word;
        }
    }
    return "";
}

}  // namespace scree

#pragma once

#include <span>

#include <scree/dynamics/contact.hpp>

namespace scree {

/// Whether a contact has stuck for as many accepted steps as `values` past ones, and is stuck now, so that
/// its stored force is a state with a past of its own. One that slips has its force from the limit.
bool remembers(const Contact& contact, const ContactResult& result, std::size_t values);

/// Σ weights[k] of its stored force, the trial one first and then the past ones, each brought to the present
/// plane: as the distance [m] for which its spring stands; or of its rolling spring where that is more.
/// `turns_a[j]`: A's turn since the j-th past time.
double stored_difference(const Contact& contact, const ContactResult& result, std::span<const double> weights,
                         std::span<const Quat> turns_a, std::span<const Quat> turns_b);

}  // namespace scree

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <scree/contact/patch_record.hpp>
#include <scree/mesh/saved_state.hpp>

namespace scree {

/// The highest order of the time stepping, and so the most that a contact remembers.
constexpr std::size_t highest_order = 5;

/// The tangential state of a contact as it was accepted: one vector f_t + (m_n/r̄) n, the friction force on A
/// in the plane across the normal and the torsional moment over r̄ along it. World axes of its own time.
struct FrictionRecord {
    Vec3 force = Vec3::Zero();    ///< [N]
    Vec3 normal = Vec3::UnitZ();  ///< the normal that it belongs to
    double stiffness = 0;         ///< kt [N/m] that it was stored with
    bool slipping = false;        ///< it was at its limit
    Vec3 rolling = Vec3::Zero();  ///< the moment against rolling over Lc/2 [N], across the normal
};
void visit_state(auto& with, StateOf<FrictionRecord> auto& record) {
    auto& [force, normal, stiffness, slipping, rolling] = record;
    with(force, normal, stiffness, slipping, rolling);
}

/// What a contact remembers of accepted steps. Only an accepted step changes it.
struct ContactHistory {
    std::array<FrictionRecord, highest_order> past;  ///< the latest first
    std::size_t age = 0;                             ///< accepted steps in contact, as far as they are kept
    std::vector<PatchRecord> patch;                  ///< as `past`, where friction is on the cells of a patch
    std::size_t patch_age = 0;                       ///< as `age`
    bool centre_line = false;                        ///< the normal was the line of centres
    double normal_energy = 0;                        ///< stored [J], where the law has a potential
    double tangential_energy = 0;                    ///< stored [J]
    double torsional_energy = 0;                     ///< stored [J]
    double rolling_energy = 0;                       ///< stored [J]
    double cohesive_energy = 0;                      ///< [J], below 0
    /// What a law with a history of its own keeps beside `past`: as many records of plain numbers, the latest
    /// first; empty for all other laws.
    std::vector<double> own;

    /// An accepted step in contact; without cells: those that were there are forgotten.
    void push(const FrictionRecord& record, std::span<const PatchRecord> cells = {}) {
        for (std::size_t j = past.size() - 1; j > 0; --j) {
            past[j] = past[j - 1];
        }
        past[0] = record;
        if (age < past.size()) {
            ++age;
        }
        patch_age = cells.empty() ? 0 : std::min(patch_age + 1, past.size());
        if (!cells.empty()) {
            push_patch(cells.front());
        }
    }
    /// The law's own record of the step; all are of one length.
    void push_own(std::span<const double> record) {
        own.resize(past.size() * record.size());
        std::copy_backward(own.begin(), own.end() - static_cast<std::ptrdiff_t>(record.size()), own.end());
        std::copy(record.begin(), record.end(), own.begin());
    }
    /// An accepted step without force.
    void clear() {
        age = patch_age = 0;
        centre_line = false;
        normal_energy = tangential_energy = torsional_energy = rolling_energy = cohesive_energy = 0;
    }
    /// Forgets all but the latest step.
    void shorten() {
        age = std::min<std::size_t>(age, 1);
        patch_age = std::min<std::size_t>(patch_age, 1);
    }

  private:
    void push_patch(const PatchRecord& record) {
        patch.resize(past.size());
        std::rotate(patch.begin(), patch.end() - 1, patch.end());
        patch.front() = record;
    }
};
void visit_state(auto& with, StateOf<ContactHistory> auto& history) {
    auto& [past, age, patch, patch_age, centre_line, normal_energy, tangential_energy, torsional_energy,
           rolling_energy, cohesive_energy, own] = history;
    with(past, patch, centre_line, normal_energy, tangential_energy, torsional_energy, rolling_energy,
         cohesive_energy, own);
    with.up_to(past.size(), age);
    with.up_to(patch.size(), patch_age);
}

}  // namespace scree

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <scree/scenes/scene_description.hpp>

namespace scree {

/// What a scene enters of all that a run can do, and what it leaves out.
struct Features {
    std::vector<std::string> used;      ///< names, in a fixed order
    std::vector<std::string> left_out;  ///< all other names, likewise

    /// Whether a feature is among those used.
    [[nodiscard]] bool uses(std::string_view feature) const;
};

/// Of a checked scene.
Features scene_features(const SceneDescription& scene);

}  // namespace scree

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <scree/scenes/scene_description.hpp>

namespace scree {

/// What a scene enters of all that a run can do, and what it leaves out.
struct Features {
    std::vector<std::string> used;
    std::vector<std::string> left_out;

    [[nodiscard]] bool uses(std::string_view feature) const;
};

Features scene_features(const SceneDescription& scene);

}  // namespace scree

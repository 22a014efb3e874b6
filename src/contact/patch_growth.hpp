#pragma once

#include <scree/contact/law.hpp>

namespace scree {

/// d‖S‖/‖S‖ by the nine unknowns, of a patch that has an area. The input's rates must be set.
inline Row9 patch_growth(const ContactInput& in) {
    const double square = in.geometry.area * in.geometry.area;
    const Row6 by_xi = in.geometry.area_vector.transpose() * in.geometry.boundary.topRows<3>();
    return by_xi * in.rates->xi / square;
}

}  // namespace scree

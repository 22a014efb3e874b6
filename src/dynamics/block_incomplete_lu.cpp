#include <scree/dynamics/block_incomplete_lu.hpp>

#include <limits>

namespace scree {

namespace {

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

}  // namespace

bool BlockIncompleteLU::eliminate(const BlockMatrix& matrix) {
    factors_ = matrix;
    inverse_.resize(at(matrix.size()));
    where_.assign(at(matrix.size()), none);
    for (int row = 0; row < factors_.size(); ++row) {
        eliminate_row(row);
        if (!inverse_[at(row)].allFinite()) {
            return false;
        }
    }
    return true;
}

void BlockIncompleteLU::eliminate_row(int row) {
    for (std::size_t place = factors_.begin(row); place < factors_.end(row); ++place) {
        where_[at(factors_.column(place))] = place;
    }
    for (std::size_t place = factors_.begin(row); factors_.column(place) < row; ++place) {
        const int pivot = factors_.column(place);
        const Mat6 multiplier = factors_.block(place) * inverse_[at(pivot)];
        factors_.block(place) = multiplier;
        for (std::size_t other = factors_.end(pivot); other-- > factors_.begin(pivot);) {
            const int column = factors_.column(other);
            if (column <= pivot) {
                break;
            }
            if (where_[at(column)] != none) {
                factors_.block(where_[at(column)]).noalias() -= multiplier * factors_.block(other);
            }
        }
    }
    inverse_[at(row)] = factors_.block(where_[at(row)]).inverse();
    for (std::size_t place = factors_.begin(row); place < factors_.end(row); ++place) {
        where_[at(factors_.column(place))] = none;
    }
}

Eigen::VectorXd BlockIncompleteLU::solve(const Eigen::VectorXd& right) const {
    Eigen::VectorXd x = right;
    for (int row = 0; row < factors_.size(); ++row) {
        auto part = x.segment<6>(6 * row);
        for (std::size_t place = factors_.begin(row); factors_.column(place) < row; ++place) {
            part.noalias() -= factors_.block(place) * x.segment<6>(6 * factors_.column(place));
        }
    }
    for (int row = factors_.size(); row-- > 0;) {
        Vec6 part = x.segment<6>(6 * row);
        for (std::size_t place = factors_.end(row); factors_.column(--place) > row;) {
            part.noalias() -= factors_.block(place) * x.segment<6>(6 * factors_.column(place));
        }
        x.segment<6>(6 * row).noalias() = inverse_[at(row)] * part;
    }
    return x;
}

}  // namespace scree

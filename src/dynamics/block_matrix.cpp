#include <scree/dynamics/block_matrix.hpp>

#include <algorithm>
#include <tuple>

namespace scree {

void BlockMatrix::clear(int size) {
    size_ = size;
    entries_.clear();
    loose_.clear();
}

void BlockMatrix::add(int row, int column, const Mat6& block) {
    entries_.push_back({row, column, loose_.size()});
    loose_.push_back(block);
}

void BlockMatrix::finish() {
    std::sort(entries_.begin(), entries_.end(), [](const Entry& a, const Entry& b) {
        return std::tie(a.row, a.column, a.place) < std::tie(b.row, b.column, b.place);
    });
    begin_.assign(static_cast<std::size_t>(size_) + 1, 0);
    columns_.clear();
    blocks_.clear();
    int last_row = -1;
    for (const Entry& entry : entries_) {
        if (entry.row == last_row && entry.column == columns_.back()) {
            blocks_.back() += loose_[entry.place];
            continue;
        }
        columns_.push_back(entry.column);
        blocks_.push_back(loose_[entry.place]);
        last_row = entry.row;
        begin_[static_cast<std::size_t>(entry.row) + 1] = blocks_.size();
    }
    for (std::size_t row = 1; row < begin_.size(); ++row) {
        begin_[row] = std::max(begin_[row], begin_[row - 1]);
    }
}

bool BlockMatrix::all_finite() const {
    return std::all_of(blocks_.begin(), blocks_.end(), [](const Mat6& block) { return block.allFinite(); });
}

// The pattern is symmetric, so that the rows of a block row are, transposed, the columns of a block column.
void BlockMatrix::expand(Eigen::SparseMatrix<double>& matrix) const {
    const Eigen::Index scalars = 6 * size_;
    matrix.resize(scalars, scalars);
    matrix.resizeNonZeros(static_cast<Eigen::Index>(36 * blocks_.size()));
    int* outer = matrix.outerIndexPtr();
    for (int column = 0; column < size_; ++column) {
        const auto blocks = static_cast<int>(end(column) - begin(column));
        for (int c = 0; c < 6; ++c) {
            outer[6 * column + c + 1] = outer[6 * column + c] + 6 * blocks;
        }
    }
    std::vector<int> filled(static_cast<std::size_t>(size_), 0);
    for (int row = 0; row < size_; ++row) {
        for (std::size_t place = begin(row); place < end(row); ++place) {
            const int column = columns_[place];
            int& before = filled[static_cast<std::size_t>(column)];
            for (int c = 0; c < 6; ++c) {
                const int first = outer[6 * column + c] + 6 * before;
                for (int r = 0; r < 6; ++r) {
                    matrix.innerIndexPtr()[first + r] = 6 * row + r;
                    matrix.valuePtr()[first + r] = blocks_[place](r, c);
                }
            }
            ++before;
        }
    }
}

}  // namespace scree

#pragma once

#include <span>
#include <vector>

#include <Eigen/Sparse>

#include <scree/contact/motion.hpp>

namespace scree {

/// A square matrix of 6×6 blocks, kept row by row.
class BlockMatrix {
  public:
    /// Of `size` block rows, empty.
    void clear(int size);
    /// Blocks at one place are summed. finish() must follow before anything is read.
    void add(int row, int column, const Mat6& block);
    /// Sorts and sums what was added.
    void finish();

    /// How many block rows.
    [[nodiscard]] int size() const { return size_; }
    /// The place of a row's first block.
    [[nodiscard]] std::size_t begin(int row) const { return begin_[static_cast<std::size_t>(row)]; }
    /// One past the place of its last block.
    [[nodiscard]] std::size_t end(int row) const { return begin_[static_cast<std::size_t>(row) + 1]; }
    /// The column of the block at a place.
    [[nodiscard]] int column(std::size_t place) const { return columns_[place]; }
    /// The block at a place.
    [[nodiscard]] const Mat6& block(std::size_t place) const { return blocks_[place]; }
    /// The same, to be changed.
    [[nodiscard]] Mat6& block(std::size_t place) { return blocks_[place]; }
    /// Whether no entry is infinite or not a number.
    [[nodiscard]] bool all_finite() const;

    /// The same as scalars, into a matrix whose memory is used again. The pattern must be symmetric.
    void expand(Eigen::SparseMatrix<double>& matrix) const;

  private:
    struct Entry {
        int row, column;
        std::size_t place;  ///< in loose_
    };

    int size_ = 0;
    std::vector<Entry> entries_;
    std::vector<Mat6> loose_;  ///< as they were added
    std::vector<std::size_t> begin_;
    std::vector<int> columns_;
    std::vector<Mat6> blocks_;
};

}  // namespace scree

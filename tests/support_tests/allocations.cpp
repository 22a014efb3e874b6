#include <memory>
#include <vector>

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include <tests/support/allocations.hpp>

using scree::test::AllocationCount;

TEST_CASE("The allocation counter sees containers and Eigen's matrices", "[support]") {
    std::vector<double> values;
    Eigen::MatrixXd matrix;

    AllocationCount containers;
    values.resize(100);
    CHECK(containers.count() == 1);

    AllocationCount matrices;
    matrix.setZero(10, 10);
    CHECK(matrices.count() == 1);

    AllocationCount nothing;
    matrix.diagonal().setConstant(values[3]);
    const Eigen::Matrix3d product = matrix.topLeftCorner<3, 3>() * Eigen::Matrix3d::Identity();
    values[4] = product.sum();
    CHECK(nothing.count() == 0);
}

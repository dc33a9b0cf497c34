#include "lessons/cost/fit.h"

#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace zproof::study::cost {
namespace {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

void require_sound(const std::vector<Observation>& rows) {
    if (rows.empty() || rows.size() < rows.front().factor.size())
        throw std::invalid_argument("least squares: fewer rows than constants; measure more runs");
    for (const Observation& row : rows)
        if (row.factor.size() != rows.front().factor.size() || !(row.measured > 0))
            throw std::invalid_argument(
                "least squares: a row with another number of factors or without a time");
}

Matrix design_of(const std::vector<Observation>& rows) {
    Matrix a(Eigen::Index(rows.size()), Eigen::Index(rows.front().factor.size()));
    for (Eigen::Index i = 0; i < a.rows(); ++i)
        for (Eigen::Index j = 0; j < a.cols(); ++j)
            a(i, j) = rows[std::size_t(i)].factor[std::size_t(j)] / rows[std::size_t(i)].measured;
    return a;
}

/// Columns brought to unit length, so that the condition says nothing about units; a column of zeros stays.
Vector brought_to_unit_length(Matrix& a) {
    Vector length = a.colwise().norm().transpose();
    for (Eigen::Index j = 0; j < a.cols(); ++j) {
        if (length(j) == 0) length(j) = 1;
        a.col(j) /= length(j);
    }
    return length;
}

std::vector<double> values_of(const Vector& v) { return {v.data(), v.data() + v.size()}; }

}  // namespace

Fit fitted(const std::vector<Observation>& rows) {
    require_sound(rows);
    Matrix a = design_of(rows);
    const Vector length = brought_to_unit_length(a), ones = Vector::Ones(a.rows());
    const Eigen::JacobiSVD<Matrix> svd(a, Eigen::ComputeThinU | Eigen::ComputeThinV);
    const Eigen::Index rank = svd.rank();
    const Vector sigma = svd.singularValues();
    const Matrix v = svd.matrixV().leftCols(rank), u = svd.matrixU().leftCols(rank);
    const Vector inverse = sigma.head(rank).cwiseInverse();
    const Vector x = v * (inverse.asDiagonal() * (u.transpose() * ones));
    const Vector residual = a * x - ones;

    Fit fit;
    fit.rank = int(rank);
    fit.condition = sigma(0) / sigma(rank - 1);
    fit.constant = values_of(x.cwiseQuotient(length));
    fit.residual = values_of(residual);
    fit.rms_residual = std::sqrt(residual.squaredNorm() / double(rows.size()));
    fit.largest_residual = residual.cwiseAbs().maxCoeff();
    const double freedom = double(a.rows() - rank);
    const double variance = freedom > 0 ? residual.squaredNorm() / freedom : 0;
    for (Eigen::Index j = 0; j < a.cols(); ++j) {
        // The share of the j-th axis that lies in the space of the rows.
        const double determined = v.row(j).squaredNorm();
        const double spread = (v.row(j).transpose().cwiseProduct(inverse)).squaredNorm();
        fit.determined.push_back(determined);
        const bool is_fixed = determined > 1 - std::sqrt(std::numeric_limits<double>::epsilon());
        fit.standard_error.push_back(is_fixed ? std::sqrt(variance * spread) / length(j)
                                              : std::numeric_limits<double>::quiet_NaN());
    }
    return fit;
}

double predicted(const std::vector<double>& constant, const std::vector<double>& factor) {
    return std::inner_product(constant.begin(), constant.end(), factor.begin(), 0.0);
}

}  // namespace zproof::study::cost

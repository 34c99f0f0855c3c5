#include "core/diagnosis/forms/held_out_forms.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/random_source.h"
#include "core/base/statistics.h"

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

using Rows = std::vector<Index>;

/// An orthonormal basis of the columns of `matrix`.
MatrixXd orthonormal(const MatrixXd& matrix) {
  constexpr double invisible = 1e-9;
  if (matrix.cols() == 0 || matrix.rows() == 0) return MatrixXd::Zero(matrix.rows(), 1);
  Eigen::ColPivHouseholderQR<MatrixXd> qr(matrix.rows(), matrix.cols());
  qr.setThreshold(invisible);
  qr.compute(matrix);
  if (qr.rank() == 0) return MatrixXd::Zero(matrix.rows(), 1);
  return qr.householderQ() * MatrixXd::Identity(matrix.rows(), qr.rank());
}

VectorXd leastSquares(const MatrixXd& columns, const VectorXd& observed) {
  Eigen::ColPivHouseholderQR<MatrixXd> qr(columns.rows(), columns.cols());
  qr.setThreshold(1e-9);
  qr.compute(columns);
  return qr.solve(observed);
}

/// The readings of one fold, and their prediction from all other readings.
class Fold {
 public:
  Fold(const HeldOutReadings& held, int fold, Index rows) {
    for (Index i = 0; i < rows; ++i) {
      const bool isReading = i < std::ssize(held.fold);
      (isReading && held.fold[static_cast<std::size_t>(i)] == fold ? m_out : m_in).push_back(i);
    }
  }

  const Rows& out() const { return m_out; }

  /// Prediction errors of `model` with these columns at the fold's readings, after a fit to all other rows.
  VectorXd errors(const DividedModel& model, const MatrixXd& columns) const {
    MatrixXd all(model.left.size(), model.basis.cols() + columns.cols());
    all << model.basis, columns;
    const VectorXd solution = leastSquares(all(m_in, Eigen::all), model.left(m_in));
    return model.left(m_out) - all(m_out, Eigen::all) * solution;
  }

  /// Finds a form of each family in the readings outside the fold. Returns the columns and the sum of the
  /// forms over all readings. Absent if a family has no form outside the fold.
  std::optional<std::pair<MatrixXd, VectorXd>> learnt(const DividedModel& full, const FormReadings& readings,
                                                      const std::vector<FormFamily>& families,
                                                      double variance, const std::stop_token& stop) const {
    const auto outside = [&](const MatrixXd& columns) -> MatrixXd {
      return full.outside(columns)(m_in, Eigen::all);
    };
    const MatrixXd basis = orthonormal(full.basis(m_in, Eigen::all));
    VectorXd left = full.left(m_in);
    left -= basis * (basis.transpose() * left).eval();
    FormSystem system(outside, basis, left, variance);
    MatrixXd columns(readings.count, 0);
    VectorXd predicted = VectorXd::Zero(readings.count);
    for (const FormFamily& family : families) {
      const std::vector<WeighedForm> found = weighForms(system, readings, {family}, stop);
      if (found.empty() || found.front().amplitudes.size() == 0) return std::nullopt;
      const MatrixXd own = formColumns(readings, found.front().form);
      predicted += own * found.front().amplitudes;
      system.takeUp(own);
      columns.conservativeResize(Eigen::NoChange, columns.cols() + own.cols());
      columns.rightCols(own.cols()) = own;
    }
    return std::pair{std::move(columns), std::move(predicted)};
  }

  /// Tests one column of predictions on the readings of the fold alone: F and its probability.
  void test(const DividedModel& plain, const VectorXd& predicted, int eliminated, FormShrinkage& shrink,
            int folds) const {
    const MatrixXd basis = orthonormal(plain.basis(m_out, Eigen::all));
    VectorXd observed = plain.left(m_out), column = plain.outside(predicted)(m_out, Eigen::all);
    for (VectorXd* own : {&observed, &column})
      for (int again = 0; again < 2; ++again) *own -= basis * (basis.transpose() * *own).eval();
    const double square = column.squaredNorm(), along = observed.dot(column);
    const Index rank = basis.squaredNorm() > 0 ? basis.cols() : 0;
    const double freedom = static_cast<double>(std::ssize(m_out) - rank) - eliminated - 1;
    if (!(square > 0) || freedom < 1) return;
    const double explained = along * along / square, rest = observed.squaredNorm() - explained;
    const double f = explained / (rest / freedom);
    const double p = std::min(fUpperTail(f, 1, freedom).value_or(1) * folds, 1.0);
    if (std::isnan(shrink.p) || p < shrink.p || (p == shrink.p && f > shrink.f)) {
      shrink.f = f;
      shrink.p = p;
    }
  }

 private:
  Rows m_in, m_out;
};

struct Squares {
  double sum = 0;
  int count = 0;

  void add(const Rows& rows, const VectorXd& errors, const VectorXd& arcseconds) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double sigma = arcseconds[rows[i]];
      if (sigma == 0) continue;
      sum += std::pow(errors[static_cast<Index>(i)] * sigma, 2);
      ++count;
    }
  }
};

}  // namespace

std::vector<int> shuffledFolds(std::size_t count, int folds) {
  constexpr std::uint64_t seed = 20240117;
  RandomSource random(seed);
  std::vector<int> all(count);
  for (std::size_t i = 0; i < count; ++i) all[i] = static_cast<int>(i) % folds;
  for (std::size_t i = count; i > 1; --i)
    std::swap(all[i - 1], all[static_cast<std::size_t>(random.whole(0, static_cast<int>(i) - 1))]);
  return all;
}

double rmsOf(const VectorXd& left, const VectorXd& arcseconds) {
  const auto count = static_cast<double>((arcseconds.array() != 0).count());
  const double squares = left.head(arcseconds.size()).cwiseProduct(arcseconds).squaredNorm();
  return count > 0 ? std::sqrt(squares / count) : 0;
}

namespace {

/// The shrinkage on all readings by a model with the forms.
double inSample(const DividedModel& model, double before, const std::vector<FoundForm>& forms,
                const FormReadings& readings, const VectorXd& arcseconds) {
  if (!(before > 0)) return 0;
  FormSystem system(model.outside, model.basis, model.left, 1);
  for (const FoundForm& form : forms) system.takeUp(formColumns(readings, form.form));
  return 1 - rmsOf(system.left(), arcseconds) / before;
}

}  // namespace

void addShrinkage(FoundForms& found, const DividedModel& plain, const DividedModel& full,
                  const HeldOutReadings& held, const FormReadings& readings, double variance,
                  const std::stop_token& stop) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  FormShrinkage shrink{.heldOut = unknown, .f = unknown, .p = unknown};
  Squares before, plainAfter, fullAfter;
  VectorXd plainErrors = VectorXd::Constant(plain.left.size(), unknown), fullErrors = plainErrors;
  for (int f = 0; f < held.folds && !stop.stop_requested(); ++f) {
    const Fold plainly(held, f, plain.left.size()), fully(held, f, full.left.size());
    const auto learnt = fully.learnt(full, readings, found.families, variance, stop);
    if (!learnt) continue;
    before.add(plainly.out(), plainly.errors(plain, MatrixXd(plain.left.size(), 0)), held.arcseconds);
    plainErrors(plainly.out()) = plainly.errors(plain, plain.outside(learnt->first));
    fullErrors(fully.out()) = fully.errors(full, full.outside(learnt->first));
    plainAfter.add(plainly.out(), plainErrors(plainly.out()), held.arcseconds);
    fullAfter.add(fully.out(), fullErrors(fully.out()), held.arcseconds);
    plainly.test(plain, learnt->second, held.eliminated[static_cast<std::size_t>(f)], shrink, held.folds);
  }
  const Squares& after = plainAfter.sum < fullAfter.sum ? plainAfter : fullAfter;
  shrink.heldOutReadings = after.count;
  if (after.count > 0) found.heldOutErrors = &after == &plainAfter ? plainErrors : fullErrors;
  shrink.inSample = inSample(&after == &plainAfter ? plain : full, rmsOf(plain.left, held.arcseconds),
                             found.forms, readings, held.arcseconds);
  if (before.sum > 0 && after.count > 0) shrink.heldOut = 1 - std::sqrt(after.sum / before.sum);
  for (FoundForm& form : found.forms) form.shrink = shrink;
}

}  // namespace alidade

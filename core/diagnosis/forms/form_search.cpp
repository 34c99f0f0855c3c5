#include "core/diagnosis/forms/form_search.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

FormSystem::FormSystem(Outside outside, MatrixXd basis, VectorXd left, double variance)
    : m_outside(std::move(outside)),
      m_basis(std::move(basis)),
      m_left(std::move(left)),
      m_variance(variance) {}

MatrixXd FormSystem::visible(const MatrixXd& columns) const {
  MatrixXd result = m_outside(columns);
  const MatrixXd taken = m_basis.transpose() * result;
  result.noalias() -= m_basis * taken;
  return result;
}

void FormSystem::takeUp(const MatrixXd& columns) {
  constexpr double invisible = 1e-6;  // relative to the length of a column
  for (Index c = 0; c < columns.cols(); ++c) {
    VectorXd own = m_outside(columns.col(c));
    const double whole = own.norm();
    for (int again = 0; again < 2; ++again) own -= m_basis * (m_basis.transpose() * own).eval();
    if (!(own.norm() > invisible * whole)) continue;
    own.normalize();
    m_basis.conservativeResize(Eigen::NoChange, m_basis.cols() + 1);
    m_basis.rightCols(1) = own;
    m_left -= own * own.dot(m_left);
  }
}

MatrixXd FormSystem::Products::gram(Index first, Index count) const {
  const auto own = all.middleCols(first, count), shared = taken.middleCols(first, count);
  MatrixXd gram = own.transpose().lazyProduct(own);
  gram -= shared.transpose().lazyProduct(shared);
  return gram;
}

FormSystem::Products FormSystem::productsOf(const MatrixXd& columns) const {
  Products products{m_outside(columns), {}, {}};
  products.taken.noalias() = m_basis.transpose() * products.all;
  products.right.noalias() = products.all.transpose() * m_left;
  return products;
}

namespace {

class Weighing {
 public:
  Weighing(const FormSystem& system, const FormReadings& readings) : m_system(system), m_readings(readings) {}

  /// Evaluates each shape of the grid, and averages the evidence.
  WeighedForm onGrid(const FormFamily& family) const {
    const Index each = columnsOf(m_readings, family.form), count = std::ssize(family.grid);
    MatrixXd columns(m_readings.count, each * count);
    for (Index i = 0; i < count; ++i)
      columns.middleCols(i * each, each) = scaled(family.grid[static_cast<std::size_t>(i)]);
    const FormSystem::Products products = m_system.productsOf(columns);
    WeighedForm best{.form = family.form, .logPrior = family.logPrior};
    std::vector<double> logs;
    double sum = impossible;
    for (Index i = 0; i < count; ++i) {
      const Gain gain = gainOfColumns(products, i * each, each);
      logs.push_back(gain.log);
      sum = logSum(sum, gain.log);
      if (!(gain.log > best.logEvidence)) continue;
      best.form = family.grid[static_cast<std::size_t>(i)];
      best.logEvidence = gain.log;
      best.width = gain.width;
    }
    best.sigmas = spreadOnGrid(family, logs, best);
    best.logAveraged = sum - std::log(static_cast<double>(count));
    return best;
  }

  /// The spread (rms) of the shapes about the likeliest shape. It includes distant shapes that also explain
  /// the readings.
  static Eigen::Array2d spreadOnGrid(const FormFamily& family, const std::vector<double>& logs,
                                     const WeighedForm& best) {
    const Eigen::Array2d middle = shapeCoordinates(best.form);
    Eigen::Array2d squares = Eigen::Array2d::Zero();
    double all = 0;
    for (std::size_t i = 0; i < logs.size(); ++i) {
      const double share = std::exp(logs[i] - best.logEvidence);
      squares += share * (shapeCoordinates(family.grid[i]) - middle).square();
      all += share;
    }
    return all > 0 ? Eigen::Array2d((squares / all).sqrt()) : Eigen::Array2d::Zero();
  }

  /// Moves the shape numbers to their likeliest values, and sets uncertainty and amplitudes.
  void refine(WeighedForm& weighed, const FormFamily& family) const {
    const Index count = weighed.form.count();
    if (weighed.form.function == FormFunction::Step) return refineStep(weighed, family);
    if (count > 0) climb(weighed, firstSteps(family), count, family.logVolume);
    setAmplitudes(weighed, count);
  }

 private:
  const FormSystem& m_system;
  const FormReadings& m_readings;

  MatrixXd scaled(const Form& form) const { return formUnit(form.carrier) * formColumns(m_readings, form); }

  Gain gainOfColumns(const FormSystem::Products& products, Index first, Index count) const {
    constexpr double invisible = 1e-6;  // share of the squared length that rounding may leave
    const MatrixXd gram = products.gram(first, count);
    const double whole = products.all.middleCols(first, count).squaredNorm();
    if (!(gram.trace() > invisible * whole)) return {impossible, 1};
    return gainOf(formWidths(), gram, products.right.segment(first, count), m_system.variance());
  }

  Gain gainAt(const Form& form) const {
    const FormSystem::Products products = m_system.productsOf(scaled(form));
    return gainOfColumns(products, 0, products.all.cols());
  }

  Gain gainAt(Form form, const Eigen::Array2d& coordinates) const {
    setShapeCoordinates(form, coordinates);
    return gainAt(form);
  }

  static Eigen::Array2d firstSteps(const FormFamily& family) {
    const Eigen::Array2d first = shapeCoordinates(family.grid.front()),
                         second = shapeCoordinates(family.grid[1]);
    constexpr double ofWidths = 0.3;
    return {std::abs(second[0] - first[0]) / 2, ofWidths};
  }

  struct Bend {
    Eigen::Vector2d slope = Eigen::Vector2d::Zero();
    Eigen::Matrix2d curve = -Eigen::Matrix2d::Identity();
  };

  /// Slope and curvature of ln evidence by finite differences about `at`.
  Bend bendAt(const Form& form, const Eigen::Array2d& at, const Eigen::Array2d& step, double here,
              Index count) const {
    Bend bend;
    const auto value = [&](double first, double second) {
      return gainAt(form, at + Eigen::Array2d(first, second) * step).log;
    };
    for (Index i = 0; i < count; ++i) {
      const double up = value(i == 0 ? 1 : 0, i == 1 ? 1 : 0), down = value(i == 0 ? -1 : 0, i == 1 ? -1 : 0);
      bend.slope[i] = (up - down) / (2 * step[i]);
      bend.curve(i, i) = (up + down - 2 * here) / (step[i] * step[i]);
    }
    if (count == 2) {
      const double mixed =
          (value(1, 1) - value(1, -1) - value(-1, 1) + value(-1, -1)) / (4 * step[0] * step[1]);
      bend.curve(0, 1) = bend.curve(1, 0) = mixed;
    }
    return bend;
  }

  /// Takes Newton steps. Each is at most twice the step of the finite differences, which shrinks.
  void climb(WeighedForm& weighed, Eigen::Array2d step, Index count, double logVolume) const {
    constexpr int mostSteps = 9;
    Eigen::Array2d at = shapeCoordinates(weighed.form);
    double here = weighed.logEvidence;
    Bend bend;
    for (int i = 0; i < mostSteps; ++i) {
      bend = bendAt(weighed.form, at, step, here, count);
      Eigen::Array2d move = Eigen::Array2d::Zero();
      const Eigen::LLT<MatrixXd> factor(-bend.curve.topLeftCorner(count, count));
      if (factor.info() == Eigen::Success)
        move.head(count) = factor.solve(bend.slope.head(count)).array();
      else
        move.head(count) = bend.slope.head(count).array().sign() * step.head(count);
      move = move.max(-2 * step).min(2 * step);
      const Gain there = gainAt(weighed.form, at + move);
      if (there.log > here) {
        here = there.log;
        at += move;
        weighed.width = there.width;
      }
      const bool isThere = factor.info() == Eigen::Success && (move.abs() <= step / 2).all();
      const Eigen::Vector2d scale =
          bend.curve.diagonal().cwiseAbs().cwiseMax(1e-12).cwiseSqrt().cwiseInverse();
      // Stops when the finite differences are as fine as the uncertainty of the shape numbers: on this scale
      // ln evidence is a parabola.
      if (isThere && (scale.head(count).array() > step.head(count) / 2).all()) break;
      step = isThere ? (step / 4).max(step.min(scale.array())) : Eigen::Array2d(step * 0.6);
    }
    setShapeCoordinates(weighed.form, at);
    weighed.logEvidence = here;
    setUncertainty(weighed, bend, count, logVolume);
  }

  void setUncertainty(WeighedForm& weighed, const Bend& bend, Index count, double logVolume) const {
    const Eigen::LLT<MatrixXd> factor(-bend.curve.topLeftCorner(count, count));
    if (factor.info() != Eigen::Success) {
      weighed.sigmas.setConstant(std::numeric_limits<double>::infinity());
      return;
    }
    const MatrixXd covariance = factor.solve(MatrixXd::Identity(count, count));
    weighed.sigmas.head(count) = weighed.sigmas.head(count).max(covariance.diagonal().array().sqrt());
    const double logPeak = static_cast<double>(count) / 2 * std::log(2 * std::numbers::pi) -
                           factor.matrixLLT().diagonal().array().log().sum();
    weighed.logAveraged = weighed.logEvidence + std::min(logPeak - logVolume, 0.0);
  }

  /// Sets the σ of a step, which has the same effect at all places between two values of the argument.
  void refineStep(WeighedForm& weighed, const FormFamily& family) const {
    double gap = 0;
    for (std::size_t i = 1; i < family.grid.size(); ++i)
      if (family.grid[i].numbers[0] == weighed.form.numbers[0] ||
          family.grid[i - 1].numbers[0] == weighed.form.numbers[0])
        gap = std::max(gap, family.grid[i].numbers[0] - family.grid[i - 1].numbers[0]);
    weighed.sigmas[0] = std::max(weighed.sigmas[0], gap / std::sqrt(12.0));
    setAmplitudes(weighed, 0);
  }

  void setAmplitudes(WeighedForm& weighed, Index count) const {
    weighed.amplitudes = amplitudesAt(weighed, weighed.form, &weighed.covariance);
    if (weighed.form.isFree()) weighed.places = placesOf(m_readings, weighed.form);
    const Eigen::Array2d at = shapeCoordinates(weighed.form);
    for (Index i = 0; i < count; ++i) {
      if (!std::isfinite(weighed.sigmas[i])) continue;
      Form moved = weighed.form;
      Eigen::Array2d there = at;
      there[i] += weighed.sigmas[i];
      setShapeCoordinates(moved, there);
      const VectorXd change = amplitudesAt(weighed, moved, nullptr) - weighed.amplitudes;
      weighed.covariance += change * change.transpose();
    }
  }

  VectorXd amplitudesAt(const WeighedForm& weighed, const Form& form, MatrixXd* covariance) const {
    const FormSystem::Products products = m_system.productsOf(scaled(form));
    const Index count = products.all.cols();
    MatrixXd normal = products.gram(0, count);
    normal.diagonal().array() += m_system.variance() / (weighed.width * weighed.width);
    const double unit = formUnit(form.carrier);
    const Eigen::LDLT<MatrixXd> factor(normal);
    if (covariance)
      *covariance = unit * unit * m_system.variance() * factor.solve(MatrixXd::Identity(count, count));
    return unit * factor.solve(products.right);
  }
};

}  // namespace

double logSumOf(const std::vector<WeighedForm>& all) {
  double sum = impossible;
  for (const WeighedForm& each : all) sum = logSum(sum, each.logPosterior());
  return sum;
}

std::vector<WeighedForm> weighForms(const FormSystem& system, const FormReadings& readings,
                                    const std::vector<FormFamily>& families, const std::stop_token& stop) {
  constexpr std::size_t mostRefined = 16;
  constexpr double hopeless = 0.25;  // share of the best ln evidence; forms with less are not refined
  const Weighing weighing(system, readings);
  std::vector<std::pair<WeighedForm, const FormFamily*>> all;
  for (const FormFamily& family : families) {
    if (stop.stop_requested()) return {};
    all.emplace_back(weighing.onGrid(family), &family);
  }
  const auto byPeak = [](const auto& one) { return -(one.first.logEvidence + one.first.logPrior); };
  std::ranges::stable_sort(all, {}, byPeak);
  const double best = all.empty() ? 0 : all.front().first.logEvidence;
  std::vector<WeighedForm> result;
  for (std::size_t i = 0; i < all.size(); ++i) {
    auto& [weighed, family] = all[i];
    if (i < mostRefined && weighed.logEvidence > hopeless * best) weighing.refine(weighed, *family);
    result.push_back(std::move(weighed));
  }
  std::ranges::stable_sort(result, {}, [](const WeighedForm& one) { return -one.logPosterior(); });
  return result;
}

}  // namespace alidade

#include "core/diagnosis/forms/form_component.h"

#include <algorithm>
#include <cmath>

#include "core/effects/cause_ids.h"

namespace alidade {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

namespace {

ErrorSource sourceOf(const Form& form) {
  if (form.of == FormArgument::T || form.of == FormArgument::Leg) return ErrorSource::Time;
  return form.isMillimetres() || form.carrier == FormCarrier::Slider ? ErrorSource::Guideway
                                                                     : ErrorSource::Instrument;
}

}  // namespace

FormComponent::FormComponent(const Leftover& leftover, const FormReadings& readings,
                             const std::vector<const WeighedForm*>& forms)
    : m_source(sourceOf(forms.front()->form)), m_columns(readings.count, 0) {
  for (const WeighedForm* form : forms) add(readings, *form);
  const MatrixXd visible = leftover.visible(m_columns);
  m_gram = visible.transpose() * visible;
}

std::string_view FormComponent::id() const {
  return formId;
}

const std::vector<Width>& FormComponent::widths() const {
  static const std::vector<Width> widths = evenly({1});
  return widths;
}

void FormComponent::add(const FormReadings& readings, const WeighedForm& weighed) {
  const MatrixXd own = formColumns(readings, weighed.form, weighed.places);
  const double unit = formUnit(weighed.form.carrier) * weighed.width;
  const auto append = [&](const MatrixXd& columns, const VectorXd& weights) {
    const Index before = m_columns.cols(), all = before + columns.cols();
    m_columns.conservativeResize(Eigen::NoChange, all);
    m_columns.rightCols(columns.cols()) = columns;
    m_found.conservativeResize(all);
    m_found.tail(columns.cols()) = weights;
  };
  append(unit * own, weighed.amplitudes / unit);
  const Eigen::Array2d at = shapeCoordinates(weighed.form);
  for (Index i = 0; i < weighed.form.count(); ++i) {
    if (!std::isfinite(weighed.sigmas[i])) continue;
    Form moved = weighed.form;
    Eigen::Array2d there = at;
    there[i] += weighed.sigmas[i];
    setShapeCoordinates(moved, there);
    append((formColumns(readings, moved, weighed.places) - own) * weighed.amplitudes, VectorXd::Zero(1));
  }
}

}  // namespace alidade

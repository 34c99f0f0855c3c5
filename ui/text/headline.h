#pragma once

#include "core/evaluation/gap.h"
#include "ui/text/verdict_text.h"

namespace alidade::ui {

/// The one result in large type, with the small type below it. Window, inset, Large Display and report all
/// show it: Δd, measured, with U, tolerance and verdict.
struct Headline {
  QString name;                ///< "Δd, measured", or "Δd, fit only" while provisional
  QString figure;              ///< "1.30 ± 0.74 mm", or briefly why there is none
  QString tip;                 ///< the figure to six decimals and what it includes; may be empty
  QString tolerance;           ///< "Tolerance ± 2.5 mm"; empty if none is stated
  VerdictText verdict;         ///< its word is the fourth part of the large type
  QString fitOnly;             ///< "Δd, fit only: 1.31 ± 0.21 mm", in small type; empty without Δd
  QString fitOnlyDetails;      ///< its coverage, k and u
  QString reference;           ///< Δd minus the reference, if the session states one
  bool isMeasured = false;     ///< the figure is Δd, measured
  bool isProvisional = false;  ///< the diagnosis is running; the figure is Δd, fit only

  /// "Δd, measured: 1.30 ± 0.74 mm", on one line.
  QString nameAndFigure() const;
  /// "Tolerance ± 2.5 mm · Accepted", on one line.
  QString toleranceAndVerdict() const;
};

/// The headline while the diagnosis of the evaluation is running.
Headline headlineOf(const Evaluation& evaluation);
/// The headline once the diagnosis has ended, with a result or without one.
Headline headlineOf(const Gap& gap);

}  // namespace alidade::ui

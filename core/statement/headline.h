#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/diagnosis/dependence.h"
#include "core/evaluation/gap.h"
#include "core/statement/tolerance_scale.h"

namespace alidade {

/// The arc's centre relative to the axis of rotation, with the axis at 0°, mm; at 180° it is opposite.
struct CentreOffset {
  double inPlane = 0, inPlaneExpanded = 0;  ///< Δd, measured, up
  double across = 0, acrossExpanded = 0;    ///< Δz, towards the theodolite
  std::optional<double> tolerance = {};
  bool isOfDistance = false;  ///< the tolerance applies to the distance from the axis, not to Δd
};

/// The one result of a session: console, window, inset, Large Display and report show these lines. The texts
/// are in the language of the thread that made them.
struct Headline {
  /// A line of small type below the result.
  struct Line {
    enum class Kind {
      Interval,      ///< an interval crosses the limit, so the verdict is open
      Across,        ///< Δz; for a tolerance of the distance, Δd and Δz
      Gap,           ///< model and readings disagree: the condition of the verdict, or why it is open
      Jump,          ///< the verdict holds unless the tripod was knocked
      Row,           ///< the verdict depends on a single row
      Undetectable,  ///< effects that these readings cannot show, of which a plausible size moves Δd by more
                     ///< than U
      Reference,     ///< Δd minus the reference, and whether they agree
      Seal,          ///< who sealed the session, and whether it was changed since
    };

    Kind kind = Kind::Across;
    std::string text;
    bool isWarning = false;  ///< must be read before the verdict is used, or says why it is open
  };

  std::string name;            ///< "Δd", "Δd, fit only" while provisional, "d" where the distance is judged
  std::string figure;          ///< "1.30 ± 0.74 mm", or briefly why there is no figure
  std::string tip = {};        ///< the figure to six decimals and what it includes; may be empty
  std::string tolerance = {};  ///< "tolerance ± 2.5 mm"; empty if none is stated
  std::string verdict = {};    ///< "Accepted", "No verdict", "Provisional: the diagnosis is running."
  std::optional<Verdict> decided = {};       ///< absent: no verdict, or a verdict of the fit only
  std::optional<ToleranceScale> scale = {};  ///< absent without a tolerance, a figure or a finite U
  std::optional<CentreOffset> offset = {};   ///< absent if Δz was not measured
  std::vector<Line> lines = {};
  std::string sentence = {};        ///< the basis of the verdict, or why there is no verdict; may be empty
  std::string fitOnly = {};         ///< "Δd, fit only: 1.31 ± 0.21 mm"; empty without Δd
  std::string fitOnlyDetails = {};  ///< coverage, k and u of Δd, fit only
  bool isMeasured = false;          ///< the figure includes every catalogued effect
  bool isProvisional = false;       ///< the diagnosis is running; the figure is that of the fit only

  /// "Δd = 1.30 ± 0.74 mm"; "Δd: not determined by these readings".
  std::string nameAndFigure() const;
  /// "Accepted · tolerance ± 2.5 mm".
  std::string verdictAndTolerance() const;
  /// The text of the line of this kind; empty without it.
  std::string line(Line::Kind kind) const;
  /// The condition of the verdict, or why it is open: the lines `Gap` and `Jump`; may be empty.
  std::string condition() const;
};

/// The headline while the diagnosis of the evaluation is running.
Headline headlineOf(const Evaluation& evaluation);
/// The headline once the diagnosis has ended, with a result or without one.
Headline headlineOf(const Gap& gap);
/// The headline from the parts of an evaluation. A null `diagnosis` means that none was made.
Headline headlineOf(const Measurement& measurement, const SessionFit& fit, const Diagnosis* diagnosis,
                    const std::vector<Dependence>& dependences = {});

}  // namespace alidade

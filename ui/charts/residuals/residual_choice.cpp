#include "ui/charts/residuals/residual_choice.h"

#include <QCoreApplication>
#include <QSettings>
#include <QVariantList>
#include <cmath>

namespace alidade::ui {
namespace {

struct ChoiceText {
  Q_DECLARE_TR_FUNCTIONS(ChoiceText)
};

QString key(const char* name) {
  return QStringLiteral("charts/residuals/") + QString::fromLatin1(name);
}

/// The stored number of a round or face; absent for 0, which means that all are chosen.
std::optional<int> numberIn(const QSettings& settings, const char* name) {
  const int number = settings.value(key(name), 0).toInt();
  return number > 0 ? std::optional(number) : std::nullopt;
}

}  // namespace

QString circleName(CircleRead circle) {
  if (circle == CircleRead::Slider) return ChoiceText::tr("slider");
  return circle == CircleRead::Horizontal ? ChoiceText::tr("horizontal") : ChoiceText::tr("vertical");
}

const char* nameOf(CircleRead circle) {
  if (circle == CircleRead::Slider) return "slider";
  return circle == CircleRead::Horizontal ? "horizontal" : "vertical";
}

ResidualChoice::Axis ResidualChoice::axis() const {
  if (over == Over::Normal) return Axis::Normal;
  if (over == Over::Count) return isStandardised ? Axis::StandardisedClasses : Axis::Classes;
  return isStandardised ? Axis::Standardised : Axis::Arcsec;
}

ResidualChoice keptResidualChoice() {
  const QSettings settings;
  ResidualChoice choice;
  const int last = static_cast<int>(ResidualChoice::Over::Count);
  const int over = settings.value(key("over"), 0).toInt();
  choice.over = static_cast<ResidualChoice::Over>(over >= 0 && over <= last ? over : 0);
  choice.isStandardised = settings.value(key("standardised"), false).toBool();
  choice.rows = {.round = numberIn(settings, "round"), .face = numberIn(settings, "face")};
  choice.horizontal = settings.value(key("horizontal"), true).toBool();
  choice.vertical = settings.value(key("vertical"), true).toBool();
  choice.slider = settings.value(key("slider"), false).toBool();
  const QVariantList reaches = settings.value(key("reaches")).toList();
  for (std::size_t i = 0; i < choice.reaches.size(); ++i) {
    const double reach = reaches.value(static_cast<qsizetype>(i)).toDouble();
    choice.reaches[i] = reach > 0 && std::isfinite(reach) ? reach : 0;
  }
  return choice;
}

void keep(const ResidualChoice& choice) {
  QSettings settings;
  settings.setValue(key("over"), static_cast<int>(choice.over));
  settings.setValue(key("standardised"), choice.isStandardised);
  settings.setValue(key("round"), choice.rows.round.value_or(0));
  settings.setValue(key("face"), choice.rows.face.value_or(0));
  settings.setValue(key("horizontal"), choice.horizontal);
  settings.setValue(key("vertical"), choice.vertical);
  settings.setValue(key("slider"), choice.slider);
  settings.setValue(key("reaches"), QVariantList(choice.reaches.begin(), choice.reaches.end()));
}

}  // namespace alidade::ui

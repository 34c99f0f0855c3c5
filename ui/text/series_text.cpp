#include "ui/text/series_text.h"

#include <QCoreApplication>

#include "core/series/history/history_sentences.h"
#include "ui/text/entry_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

struct SeriesTexts {
  Q_DECLARE_TR_FUNCTIONS(SeriesTexts)
};

}  // namespace

QString deviceText(const DeviceHistory& device) {
  const QString name = visibleLine(device.name), serial = visibleLine(device.serial);
  if (name.isEmpty() && serial.isEmpty()) return SeriesTexts::tr("device without a name");
  if (serial.isEmpty()) return name;
  return name.isEmpty() ? SeriesTexts::tr("serial number %1").arg(serial)
                        : SeriesTexts::tr("%1, serial number %2").arg(name, serial);
}

QStringList historyLines(const DeviceHistory& device, const QuantityHistory& quantity) {
  QStringList lines;
  for (const std::string& sentence : historySentences(quantity.history, quantity.unit))
    lines.append(visibleLine(sentence));
  if (quantity.id == "intersection") lines.append(qText(sharedSentence(device)));
  if (quantity.id.starts_with("o1_") || quantity.id.starts_with("o2_"))
    lines.append(SeriesTexts::tr(
        "O1 and O2 refer to the theodolite: compare them only between set-ups on the same pillar."));
  return lines;
}

QString intersectionText(const Epoch& epoch) {
  return valueWithUncertainty(epoch.intersection.value, epoch.intersection.expanded, QStringLiteral("mm"));
}

QString verdictText(const Epoch& epoch) {
  if (!epoch.verdict) return {};
  switch (*epoch.verdict) {
    case Verdict::Accept:
      return SeriesTexts::tr("accept");
    case Verdict::Reject:
      return SeriesTexts::tr("reject");
    case Verdict::Undecided:
      break;
  }
  return SeriesTexts::tr("undecided");
}

}  // namespace alidade::ui

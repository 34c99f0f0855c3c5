#include "ui/instrument/check_table.h"

#include <QVBoxLayout>

#include "core/series/instrument_check/check_findings.h"
#include "ui/panels/parts/data_table.h"
#include "ui/text/entry_text.h"
#include "ui/text/quantity_text.h"
#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

constexpr int longestStation = 60;

QString scatterText(const CheckScatter& scatter) {
  if (!(scatter.dof > 0)) return notStated();
  return QStringLiteral("%1 (%2)").arg(arcsecText(scatter.s(), 2), numberText(scatter.dof, 0));
}

QString meanText(const PairMean& mean) {
  return qText(withU(mean.value, mean.u, "″"));
}

QString otherText(const std::optional<TwoCauses>& causes, const char* unit) {
  return causes ? qText(withU(causes->other, causes->uOther, unit)) : notStated();
}

}  // namespace

CheckTable::CheckTable(QWidget* parent) : QWidget(parent), m_table(createTable()) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(m_table);
}

DataTable* CheckTable::createTable() {
  using OfStation = std::function<QString(const StationCheck&)>;
  using OfAll = std::function<QString(const InstrumentCheck&)>;
  const auto text = [this](OfStation ofStation, OfAll ofAll) {
    return [this, ofStation = std::move(ofStation), ofAll = std::move(ofAll)](int row) {
      const StationCheck* station = stationAt(row);
      return station ? ofStation(*station) : ofAll(*m_check->check);
    };
  };
  const auto none = [](const InstrumentCheck&) { return QString(); };
  const QString sample = QStringLiteral("−12.34″ ± 0.56″");
  auto* table = new DataTable(
      {{tr("Station"), tr("Evaluated one by one; the last row holds all of them"),
        QStringLiteral("Pillar 12 east"),
        text([](const StationCheck& s) { return shortLine(s.station, longestStation); },
             [](const InstrumentCheck&) { return tr("all, pooled"); }),
        Qt::AlignLeft},
       {tr("Rounds"), tr("Complete rounds × targets"), QStringLiteral("12 × 12"),
        text([](const StationCheck& s) { return QStringLiteral("%1 × %2").arg(s.rounds).arg(s.targets); },
             none)},
       {tr("s direction (ν)"), tr("Of a direction observed once in both faces, with its degrees of freedom"),
        QStringLiteral("12.34″ (123)"),
        text([](const StationCheck& s) { return scatterText(s.direction); },
             [](const InstrumentCheck& c) { return scatterText(c.direction); })},
       {tr("s zenith (ν)"), tr("Of a zenith angle observed once in both faces, with its degrees of freedom"),
        QStringLiteral("12.34″ (123)"),
        text([](const StationCheck& s) { return scatterText(s.vertical); },
             [](const InstrumentCheck& c) { return scatterText(c.vertical); })},
       {tr("Collimation"), tr("c as of face 1, ± its standard uncertainty"), sample,
        text([](const StationCheck& s) { return meanText(s.collimation); },
             [](const InstrumentCheck& c) { return meanText(c.collimation); })},
       {tr("Index"), tr("Of the vertical circle as of face 1, ± its standard uncertainty"), sample,
        text([](const StationCheck& s) { return meanText(s.index); },
             [](const InstrumentCheck& c) { return meanText(c.index); })},
       {tr("Trunnion tilt"),
        tr("i, estimated together with the collimation, from targets at several elevations"), sample,
        text([](const StationCheck& s) { return otherText(s.causes.tilt, "″"); },
             [](const InstrumentCheck& c) { return c.tilt ? meanText(*c.tilt) : notStated(); })},
       {tr("Line of sight"), tr("e, by which it passes the axis, from targets at several distances"),
        QStringLiteral("−0.123 mm ± 0.045 mm"),
        text([](const StationCheck& s) { return otherText(s.causes.lineOfSight, " mm"); },
             [](const InstrumentCheck& c) { return otherText(c.lineOfSight, " mm"); })}});
  table->setAccessibleName(tr("Result by station"));
  table->setPlaceholder(tr("Open files, or type rounds in two faces to several targets."));
  return table;
}

const StationCheck* CheckTable::stationAt(int row) const {
  const auto& stations = m_check->check->stations;
  const auto at = static_cast<std::size_t>(row);
  return at < stations.size() ? &stations[at] : nullptr;
}

void CheckTable::setCheck(const SharedInstrument& check) {
  m_check = check;
  const std::size_t stations = check && check->check ? check->check->stations.size() : 0;
  m_table->setRows(static_cast<int>(stations > 1 ? stations + 1 : stations));
}

}  // namespace alidade::ui

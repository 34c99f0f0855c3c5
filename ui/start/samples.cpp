#include "ui/start/samples.h"

#include <QFile>

#include "core/base/phrase.h"
#include "core/session/session_file.h"

namespace alidade::ui {

const std::vector<Sample>& allSamples() {
  static const std::vector<Sample> samples{
      {"paper-table-1", QT_TRANSLATE_NOOP("Sample", "Table I of the paper"),
       QT_TRANSLATE_NOOP("Sample", "A whole measurement, with a gap: two radii that differ by 2 mm")},
      {"clean-session", QT_TRANSLATE_NOOP("Sample", "A clean session"),
       QT_TRANSLATE_NOOP("Sample", "Nothing but noise: what a sound fit looks like")},
      {"misreading", QT_TRANSLATE_NOOP("Sample", "One reading misread"),
       QT_TRANSLATE_NOOP("Sample",
                         "One reading is 10′ wrong: it is found, and the intended reading is suggested")},
      {"two-faces", QT_TRANSLATE_NOOP("Sample", "Both faces"),
       QT_TRANSLATE_NOOP("Sample", "Collimation and trunnion tilt are found, and Δd is free of them")},
      {"trunnion-tilt", QT_TRANSLATE_NOOP("Sample", "A tilted trunnion axis"),
       QT_TRANSLATE_NOOP("Sample", "One cause, found with its size")},
      {"look-alikes", QT_TRANSLATE_NOOP("Sample", "The same fault, one face"),
       QT_TRANSLATE_NOOP("Sample", "Ambiguous: indistinguishable causes, and the readings to take next")},
      {"two-causes", QT_TRANSLATE_NOOP("Sample", "Two causes at once"),
       QT_TRANSLATE_NOOP("Sample", "A trunnion tilt and a vertical circle that drifts")},
      {"knocked-tripod", QT_TRANSLATE_NOOP("Sample", "A knocked tripod"),
       QT_TRANSLATE_NOOP("Sample", "A jump after 25 of 36 readings")},
      {"noisy-readings", QT_TRANSLATE_NOOP("Sample", "Noise larger than stated"),
       QT_TRANSLATE_NOOP("Sample", "6″ where 2″ are stated, and nothing else wrong")},
      {"known-instrument", QT_TRANSLATE_NOOP("Sample", "A known trunnion tilt"),
       QT_TRANSLATE_NOOP("Sample",
                         "The instrument record states the trunnion tilt: nothing is left to explain")},
      {"stale-record", QT_TRANSLATE_NOOP("Sample", "An outdated record"),
       QT_TRANSLATE_NOOP("Sample",
                         "The instrument was knocked after its check: the outdated value is detected")},
      {"unknown-form", QT_TRANSLATE_NOOP("Sample", "A guideway out of shape"),
       QT_TRANSLATE_NOOP("Sample", "A radius with five periods in a turn: the form is found, with its size")},
      {"dented-guideway", QT_TRANSLATE_NOOP("Sample", "A dented guideway"),
       QT_TRANSLATE_NOOP("Sample", "The form of an uncatalogued effect, and where the model holds")},
      {"settling-tripod", QT_TRANSLATE_NOOP("Sample", "A settling tripod"),
       QT_TRANSLATE_NOOP("Sample", "A form in time: only the first quarter deviates")},
      {"own-effect", QT_TRANSLATE_NOOP("Sample", "An effect of one's own"),
       QT_TRANSLATE_NOOP("Sample", "A joint of the rail, typed as a formula: the cause, with its size")}};
  return samples;
}

Result<Session> readSample(const QString& name) {
  QFile file(QStringLiteral(":/samples/%1.alidade").arg(name));
  if (!file.open(QIODevice::ReadOnly)) return Problem{Phrase::of("There is no sample of this name")};
  return readSession(file.readAll().toStdString());
}

}  // namespace alidade::ui

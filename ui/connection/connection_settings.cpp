#include "ui/connection/connection_settings.h"

#include <QSettings>
#include <algorithm>

#include "core/connection/geocom_talk.h"
#include "core/connection/gsi_talk.h"

namespace alidade::ui {

namespace {

using Protocol = ConnectionSettings::Protocol;
using Parity = ConnectionSettings::Parity;

const QString connectionGroup = QStringLiteral("connection/");
constexpr int mostBauds = 4'000'000;

QString nameOf(Protocol protocol) {
  return protocol == Protocol::Gsi ? QStringLiteral("gsi") : QStringLiteral("geocom");
}

QString keyOf(Protocol protocol, const char* name) {
  return connectionGroup + nameOf(protocol) + u'/' + QString::fromLatin1(name);
}

int storedWithin(const QSettings& settings, const QString& key, int usual, int least, int most) {
  bool isNumber = false;
  const int stored = settings.value(key, usual).toInt(&isNumber);
  return isNumber && stored >= least && stored <= most ? stored : usual;
}

}  // namespace

ConnectionSettings usualConnection(Protocol protocol) {
  ConnectionSettings settings;
  settings.protocol = protocol;
  if (protocol == Protocol::Gsi) {
    settings.baudRate = 9600;
    settings.dataBits = 7;
    settings.parity = Parity::Even;
  }
  return settings;
}

ConnectionSettings rememberedConnection(Protocol protocol) {
  const QSettings stored;
  ConnectionSettings settings = usualConnection(protocol);
  settings.port = stored.value(connectionGroup + QStringLiteral("port")).toString();
  settings.intoSelected = stored.value(connectionGroup + QStringLiteral("intoSelected"), false).toBool();
  settings.baudRate = storedWithin(stored, keyOf(protocol, "baudRate"), settings.baudRate, 1, mostBauds);
  settings.dataBits = storedWithin(stored, keyOf(protocol, "dataBits"), settings.dataBits, 7, 8);
  settings.stopBits = storedWithin(stored, keyOf(protocol, "stopBits"), settings.stopBits, 1, 2);
  settings.parity = static_cast<Parity>(
      storedWithin(stored, keyOf(protocol, "parity"), static_cast<int>(settings.parity), 0, 2));
  return settings;
}

ConnectionSettings rememberedConnection() {
  const QString name = QSettings().value(connectionGroup + QStringLiteral("protocol")).toString();
  return rememberedConnection(name == nameOf(Protocol::Gsi) ? Protocol::Gsi : Protocol::GeoCom);
}

void rememberConnection(const ConnectionSettings& settings) {
  QSettings stored;
  stored.setValue(connectionGroup + QStringLiteral("protocol"), nameOf(settings.protocol));
  stored.setValue(connectionGroup + QStringLiteral("port"), settings.port);
  stored.setValue(connectionGroup + QStringLiteral("intoSelected"), settings.intoSelected);
  stored.setValue(keyOf(settings.protocol, "baudRate"), settings.baudRate);
  stored.setValue(keyOf(settings.protocol, "dataBits"), settings.dataBits);
  stored.setValue(keyOf(settings.protocol, "stopBits"), settings.stopBits);
  stored.setValue(keyOf(settings.protocol, "parity"), static_cast<int>(settings.parity));
}

std::unique_ptr<InstrumentTalk> createTalk(Protocol protocol, const TalkCircles& circles) {
  if (protocol == Protocol::Gsi) return std::make_unique<GsiTalk>(circles);
  return std::make_unique<GeoComTalk>(circles);
}

}  // namespace alidade::ui

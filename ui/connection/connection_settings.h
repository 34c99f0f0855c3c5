#pragma once

#include <QString>
#include <memory>

#include "core/connection/talk.h"

namespace alidade::ui {

/// How an instrument is talked to. Remembered, the speed and its like by protocol.
struct ConnectionSettings {
  enum class Protocol { GeoCom, Gsi };
  enum class Parity { None, Even, Odd };

  Protocol protocol = Protocol::GeoCom;
  QString port = {};  ///< "ttyUSB0", or a path such as /dev/pts/3; empty: none chosen yet
  int baudRate = 19200;
  int dataBits = 8;
  Parity parity = Parity::None;
  int stopBits = 1;
  bool intoSelected = false;  ///< readings go into the selected row, else into the next entry asked for

  bool operator==(const ConnectionSettings&) const = default;
};

/// As instruments of that protocol come.
ConnectionSettings usualConnection(ConnectionSettings::Protocol protocol);

/// Those chosen last; entries that mean nothing are as usual.
ConnectionSettings rememberedConnection();
/// Those chosen last for that protocol.
ConnectionSettings rememberedConnection(ConnectionSettings::Protocol protocol);
void rememberConnection(const ConnectionSettings& settings);

std::unique_ptr<InstrumentTalk> createTalk(ConnectionSettings::Protocol protocol, const TalkCircles& circles);

}  // namespace alidade::ui

#pragma once

#include <QString>
#include <memory>

#include "core/connection/talk.h"

namespace alidade::ui {

/// Settings of a connection to an instrument. All are remembered; baud rate, bits and parity by protocol.
struct ConnectionSettings {
  enum class Protocol { GeoCom, Gsi };
  enum class Parity { None, Even, Odd };

  Protocol protocol = Protocol::GeoCom;
  QString port = {};  ///< "ttyUSB0", or a path such as /dev/pts/3; empty: none chosen yet
  int baudRate = 19200;
  int dataBits = 8;
  Parity parity = Parity::None;
  int stopBits = 1;
  bool intoSelected = false;  ///< true: readings go into the selected row; false: into the next entry

  bool operator==(const ConnectionSettings&) const = default;
};

/// The factory settings of instruments with this protocol.
ConnectionSettings usualConnection(ConnectionSettings::Protocol protocol);

/// The settings used last; an invalid setting is replaced by its default.
ConnectionSettings rememberedConnection();
/// The settings used last with this protocol.
ConnectionSettings rememberedConnection(ConnectionSettings::Protocol protocol);
void rememberConnection(const ConnectionSettings& settings);

std::unique_ptr<InstrumentTalk> createTalk(ConnectionSettings::Protocol protocol, const TalkCircles& circles);

}  // namespace alidade::ui

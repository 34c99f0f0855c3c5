#pragma once

#include <string>
#include <string_view>

#include "core/base/result.h"

namespace alidade::console {

/// A line like that of an instrument, made by the system: what is written here is read by who opens `path()`,
/// and the other way round. Raw, and open at its other end, too, so that a reader may come and go.
class PseudoTerminal {
 public:
  static Result<PseudoTerminal> open();
  PseudoTerminal(PseudoTerminal&& other) noexcept;
  PseudoTerminal& operator=(PseudoTerminal&&) = delete;
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;
  ~PseudoTerminal();

  const std::string& path() const { return m_path; }  ///< "/dev/pts/3"
  int descriptor() const { return m_master; }
  /// What is there to be read; waits for nothing.
  std::string read() const;
  /// False: the buffer is full, since nobody reads; what did not fit is lost, as on a wire.
  bool write(std::string_view bytes) const;

 private:
  PseudoTerminal(int master, int slave, std::string path)
      : m_master(master), m_slave(slave), m_path(std::move(path)) {}

  int m_master, m_slave;
  std::string m_path;
};

}  // namespace alidade::console

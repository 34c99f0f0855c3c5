#pragma once

#include <QObject>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/finding.h"
#include "core/series/instrument_check/check_files.h"
#include "core/series/instrument_check/instrument_check.h"
#include "ui/jobs/background.h"

namespace alidade::ui {

/// The input of an instrument check.
struct InstrumentQuestion {
  struct Source {
    std::string name;
    std::shared_ptr<const std::string> bytes;
    std::optional<TableLayout> table = {};  ///< layout of typed rows
  };
  std::vector<Source> sources;
  CheckFileOptions reading;
  CheckOptions stated;
  CheckIdentity identity = {};  ///< typed; replaces what the sources state
};

struct CheckedInstrument {
  std::optional<InstrumentCheck> check;
  std::vector<Finding> findings;
  std::vector<std::string> remarks;
  CheckIdentity identity = {};
  std::vector<std::string> sources = {};  ///< names of the files
  std::string problem;                    ///< why there is no check; empty if there is a check or no input
};

using SharedInstrument = std::shared_ptr<const CheckedInstrument>;

/// Runs in the calling thread.
CheckedInstrument checkInstrument(const InstrumentQuestion& question);

/// Checks in the background; only the newest question is answered.
class InstrumentJob : public QObject {
  Q_OBJECT

 public:
  explicit InstrumentJob(QObject* parent = nullptr);

  void ask(InstrumentQuestion question);
  bool isAtWork() const { return m_work.isAtWork(); }

 signals:
  void checked(const alidade::ui::SharedInstrument& answer);

 private:
  void start(InstrumentQuestion question);

  std::optional<InstrumentQuestion> m_next;  ///< asked during another check
  Background<CheckedInstrument> m_work;
};

}  // namespace alidade::ui

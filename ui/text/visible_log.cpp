#include "ui/text/visible_log.h"

#include <QtGlobal>
#include <cstdio>

#include "ui/text/visible_text.h"

namespace alidade::ui {

namespace {

void writeVisible(QtMsgType type, const QMessageLogContext& context, const QString& message) {
  const QByteArray line = visibleLine(qFormatLogMessage(type, context, message)).toUtf8() + '\n';
  std::fwrite(line.constData(), 1, static_cast<std::size_t>(line.size()), stderr);
}

}  // namespace

void keepLogVisible() {
  qInstallMessageHandler(writeVisible);
}

}  // namespace alidade::ui

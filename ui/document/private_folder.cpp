#include "ui/document/private_folder.h"

#include <sys/stat.h>

#include <QDir>

#include "ui/document/encoded_path.h"

namespace alidade::ui {

void makePrivateFolder(const QString& folder) {
  if (QDir().mkpath(folder)) chmod(encodedPath(folder).c_str(), 0700);
}

}  // namespace alidade::ui

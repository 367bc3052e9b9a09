#pragma once

#include <QApplication>

namespace palpate
{
/// A QApplication that keeps LC_NUMERIC "C". Qt sets the user's locale; with a decimal comma, C
/// functions (of ITK, VTK and others) would then read "3.5" as 3 and write 3,5. Widgets still show
/// numbers in the user's locale, by QLocale. Its style is CheckStyle.
class Application : public QApplication
{
public:
  /// As for QApplication: both must outlive the application.
  Application(int& argc, char** argv);
};
} // namespace palpate

#pragma once

#include <QApplication>

namespace palpate
{
/// A QApplication that leaves LC_NUMERIC "C". Qt sets the user's locale, after which C functions
/// (ITK's, VTK's and others') read "3.5" as 3 and write 3,5 where the decimal point is a comma.
/// Widgets still show numbers as the user writes them, which is QLocale's.
class Application : public QApplication
{
public:
  /// As QApplication's: both must outlive the application.
  Application(int& argc, char** argv);
};
} // namespace palpate

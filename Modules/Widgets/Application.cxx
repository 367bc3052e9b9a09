#include "Application.h"

#include "CheckStyle.h"

#include <clocale>

namespace palpate
{
Application::Application(int& argc, char** argv) : QApplication(argc, argv)
{
  std::setlocale(LC_NUMERIC, "C");
  QApplication::setStyle(new CheckStyle);
}
} // namespace palpate

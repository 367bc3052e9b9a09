#include "Application.h"

#include <clocale>

namespace palpate
{
Application::Application(int& argc, char** argv) : QApplication(argc, argv)
{
  std::setlocale(LC_NUMERIC, "C");
}
} // namespace palpate

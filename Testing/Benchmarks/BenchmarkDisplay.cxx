#include "BenchmarkDisplay.h"

#include <iostream>
#include <stdexcept>

namespace palpate::bench
{
std::shared_ptr<DisplayServer> OpenDisplay()
{
  try
  {
    return std::make_shared<DisplayServer>();
  }
  catch (const std::runtime_error& error)
  {
    std::cerr << "No frames are timed: " << error.what() << '\n';
    return nullptr;
  }
}
} // namespace palpate::bench

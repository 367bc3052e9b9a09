// Draws three linked slices and a 3D view into one image, off screen: an example of using this
// module's classes together. Argument: the PNG file to write.
#include "DisplayCheck.h"
#include "PhantomViews.h"
#include "RasterImage.h"
#include "WindowImage.h"

#include <fstream>
#include <iostream>
#include <stdexcept>

int main(int argc, char** argv)
{
  if (argc != 2)
  {
    std::cerr << "usage: " << argv[0] << " IMAGE.png\n";
    return 2;
  }
  try
  {
    palpate::RequireDisplay();
    palpate::test::PhantomViews scene(1280, 800);
    scene.Views.Render();
    std::ofstream(argv[1], std::ios::binary)
        << palpate::EncodePng(palpate::ReadWindow(scene.Views.Window));
  }
  catch (const std::runtime_error& error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
  return 0;
}

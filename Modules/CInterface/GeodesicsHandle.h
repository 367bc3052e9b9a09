#pragma once

#include "SurfaceGeodesics.h"

/// A surface of the C interface along which lengths are measured.
struct palpate_geodesics
{
  palpate::SurfaceGeodesics Surface;
};

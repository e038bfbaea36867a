#include <CGAL/Flip_geodesics/make_shortest.h>

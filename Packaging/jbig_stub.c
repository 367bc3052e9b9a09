/* Stands for libjbig (GPL) in the archive: Debian's libtiff, which VTK and ITK link, needs its symbols.
   Palpate reads no TIFF. Every function reports failure to libtiff. */
#include <stddef.h>

#define JBIG_STUB_FAILS(name) int name(void) { return -1; }
JBIG_STUB_FAILS(jbg_dec_in)
JBIG_STUB_FAILS(jbg_newlen)

#define JBIG_STUB_DOES_NOTHING(name) void name(void) {}
JBIG_STUB_DOES_NOTHING(jbg_dec_init)
JBIG_STUB_DOES_NOTHING(jbg_dec_free)
JBIG_STUB_DOES_NOTHING(jbg_enc_init)
JBIG_STUB_DOES_NOTHING(jbg_enc_free)
JBIG_STUB_DOES_NOTHING(jbg_enc_out)

unsigned char* jbg_dec_getimage(void) { return NULL; }
unsigned long jbg_dec_getsize(void) { return 0; }
const char* jbg_strerror(void) { return "JBIG is not supported"; }

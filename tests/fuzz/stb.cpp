// stb's decoder, compiled here with the sanitizers and for the fuzzer's eyes: Debian's library has neither.
//
// Of an empty chunk of pixels stb asks memcpy for no bytes at a null pointer, which copies nothing anywhere (2.27, found by
// make fuzz): that one report is left out, and of its functions alone.
#define STB_IMAGE_IMPLEMENTATION
#pragma clang attribute push(__attribute__((no_sanitize("nonnull-attribute"))), apply_to = function)
#include <stb/stb_image.h>
#pragma clang attribute pop

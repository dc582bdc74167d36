/* Between light and the encoded numbers that picture files hold, by sRGB's curve. */
#ifndef LIGHT_H
#define LIGHT_H

/* Both for 0 to 1; other values go on along the curve's ends. */
double light_encode(double light);
double light_decode(double encoded);

#endif

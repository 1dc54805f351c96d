// A light operator's sections as method 8 wrote them (base64): of operatorScene(8, 3) with means over
// surfaces as in operator_sections_test.cpp. Every later reader must read them; never write this file anew.
#pragma once

namespace fiatlux {

inline constexpr char kOlderVisibility[] =
    "M/pJgFXNEh1LtKeb/LqgpWjQPfv7EhrXBwsuivQcw0NezzEE8jyainZJ1LlnBmR6QvBz2ICpi4ZklwSrxYxJZinbnj/z41Ezwp0v"
    "u1smL0Wc0ir5kot8h6Bc0kQt/xEQadC3jh2jKYzqfh7jFafPnZhD6+vNhPI1ACjzOC1DSifZkpkmsecU/lvVAYqXu/mh2uQCvxer"
    "clgt/3qvafFAgq5r/fIrAECzAjx6tfB9gCADuDn6mao9vPCIaAPbTC6OcJPNLuPcereC7BUxwgCT0zpB3ZfSoKlZXQNla9M";
inline constexpr char kOlderExchange[] = "///81wZjkq7E57WV0RIMkVrua601k+wVTnmHrus4BOWiYdmcggyK";
inline constexpr char kOlderRest[] =
    "AQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAA"
    "AQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAA"
    "AQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAQAAAwYJAgUIAQQHAAMGCQIFCAEEBwADBgkCBQgBBAcAAwYJAgUIAQQHAAMGCQIFCAEE"
    "BwADBgkCBQgBBAQDBAMEAwQDBAMEAwQDBAMEAwQDBAMEAwQDBAMEAwQDBAMEAwQDBAMEAwQDBAMEAwQDBAMEAwQDBAME";
inline constexpr char kOlderSurfaceExchange[] =
    "P/+/z4CVt29y8/zRbQxGahTc+k6iZpuceKc9jd0yFLuZ/17VEyYQWFOqtfLdQcUrvIIGPkEsUHjU9pqNQA1TFw+HJRwr1x0p/w6d"
    "lZGcYeTHywsOnrYldGbPflfyz0N+1lVabFouNsrtc9ZWg6dxBSdCcPFK7JqMW82EMxJT9DZaCoajozIZCeEAfz/ZK6Fliqz1vjvp"
    "9CJ/xG4hR4oKOBCsv4FXSOldZPsj+bv2UIXnlMCOdf8QH5HR3ZIOJpVV9aKikpSZaVWyO6HJZuqAxeH3UkVc81EW23TpaTnle6NO"
    "zhixCfLZXinKNL2GsjAm72QJCTD9tTFurOPEI0brUw1bjH2Sp0Tgme+5YqUxYXBmTxYkRU+wdS1zN27MHo/u9++TmqSqTq/tAvNB"
    "LeWdYBtxJmURUGOsWt1qsIZKUcNV6zpw4a4MhhZYSyYx/C57GDXd4Tg9umhiDI1vHO5VCLY+WgFJlzMwgn35jUwWXOm0CnxiC3km"
    "RavhC9sQsf1XFpUPNoPQR2jE5IGhmyCPkMxET6uQFwoEKLAg";

}  // namespace fiatlux

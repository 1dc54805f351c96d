// Linked with the whole of one library and with what that may use: what is missing would be an upward call.
int main() {}

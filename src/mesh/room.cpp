// room to be filled
